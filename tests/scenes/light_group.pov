// Lights that light only their group.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
light_source { <-4, 3, -5> rgb 0.3 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
light_group{ light_source{<-3,3,-3> rgb <1,0,0>} sphere{<-1,.7,0>,.7 pigment{rgb 1}} }
light_group{ light_source{<3,3,-3> rgb <0,0,1>} sphere{<1,.7,0>,.7 pigment{rgb 1}} union{box{<-.2,0,-1>,<.2,.4,-.6>} sphere{<0,.6,-.8>,.2} pigment{rgb 1}} global_lights on }
