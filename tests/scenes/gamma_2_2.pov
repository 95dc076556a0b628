// An assumed gamma of 2.2.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
sphere { 0, 0.8 pigment { rgb <0.5, 0.25, 0.75> } }
