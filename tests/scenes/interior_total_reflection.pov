// Total internal reflection, with fading.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
light_source { <-4, 3, -5> rgb 0.3 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
global_settings{max_trace_level 10}
box{<-1.4,.1,-1>,<1.6,1.3,.6> rotate y*35 pigment{rgbt <.9,.5,.9,.9>} interior{ior 2 fade_distance 1 fade_power 1.5 fade_color rgb <.9,.4,.2>} finish{reflection .2}}
