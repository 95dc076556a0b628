// Light from behind: the second diffuse value, and double_illuminate.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
light_source { <-4, 3, -5> rgb 0.3 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
disc{<-1,1,0>,<.3,0,-1>,.8 pigment{rgb <.8,.6,.3>} finish{diffuse .5,.4 phong .5}}
disc{<1,1,0>,<.3,0,-1>,.8 pigment{rgb <.8,.6,.3>} double_illuminate}
light_source{<0,2,6> rgb .8}
