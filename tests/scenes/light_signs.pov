// A negative light darkens; without a comma before its colour a light is black and somewhere else.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -9*z look_at 0 }
light_source { <0, 0, -10> -0.5 }
light_source { <3, 3, -5>, 0.9 }
light_source { <-5, 3, -5>, -0.4 }
sphere { 0, 2 pigment { rgb 1 } }
plane { y, -2 pigment { rgb 1 } }
