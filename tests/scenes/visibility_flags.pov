// no_image, no_reflection and no_shadow in a mirror and through glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
light_source { <-4, 3, -5> rgb 0.3 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
sphere{<-1,.7,0>,.7 pigment{rgb <1,.4,.3>} no_image} sphere{<1,.7,0>,.7 pigment{rgb <.3,.4,1>} no_reflection}
sphere{<0,1.8,0>,.5 pigment{rgb <.3,1,.3>} no_shadow}
plane{z,2 pigment{rgb 0} finish{reflection .8}} disc{<0,1,-2>,z,.6 pigment{rgbt .9} finish{reflection .2}}
