// An object without a shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
sphere { <-0.8, 0, 0>, 0.5 pigment { rgb <1, 0.6, 0.2> } no_shadow }
sphere { <0.8, 0, 0>, 0.5 pigment { rgb <0.3, 0.7, 1> } }
