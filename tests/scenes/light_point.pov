// Two coloured lights and their shadows; one gives no shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
light_source { <5, 4, -2> rgb <0, 0.2, 0.6> shadowless }
light_source { <-2, 3, 4> rgb <0.5, 0.2, 0> }
sphere { 0, 0.7 pigment { rgb 1 } }
