// A light_group is subtracted like any object; its lights shine on its own parts.
#version 3.7; global_settings{assumed_gamma 1} camera{location <2,2,-5> look_at 0} light_source{<3,4,-5> .5}
#default{pigment{rgb 1}}
difference { box { -1,1 } light_group { light_source { <-3,3,-5> rgb <1,0,0> } sphere { <0,0,-1>, .7 } sphere { 1, .8 } } rotate 10*y}
difference { sphere { x*2,1 } light_group { light_source { <-3,3,-5> rgb <0,1,0> } } }
light_group { light_source { <-3,3,-5> rgb <0,0,1> } difference { sphere { -x*2,1 } cylinder { -2*x-2*z,-2*x+2*z,.3} } }
