// Shadows of filtering, fading and caustic objects.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
light_source { <-4, 3, -5> rgb 0.3 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
global_settings{adc_bailout .01}
sphere{<-1,1.7,0>,.6 pigment{rgbf <.9,.3,.2,.8>} interior{caustics .7}}
box{<.3,1,-.5>,<1.6,1.1,.6> pigment{rgbft <.2,.9,.3,.5,.4>} interior{fade_distance .05 fade_power 2}}
cylinder{<0,0,-1>,<0,1,-1>,.2 pigment{gradient y color_map{[0 rgbt <1,0,0,0>][1 rgbt <0,0,1,1>]}}}
