// Lights that shine through an object only.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
light_source{<0,4,-1> rgb 1 projected_through{box{<-1,2,-1>,<.5,2.1,.5>}}}
light_source{<2,4,-3> rgb .5 shadowless projected_through{sphere{<1,2,-1>,.7}}}
sphere{<0,.5,0>,.5 pigment{rgb 1}} box{<-1.5,2.5,-1>,<-.5,2.6,1> pigment{rgb 1}}
