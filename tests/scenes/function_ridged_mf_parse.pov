// A call of f_ridged_mf while the scene is read is the first one: all calls in the picture use its H.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
#declare Height = f_ridged_mf(0.3, 0, 0.7, 1.5, 2.5, 9, 0.8, 0.9, 2);
camera { location <0, 2, -5> look_at 0 right x*4/3 }
light_source { <5, 10, -8> rgb 1 }
plane { y, -1 pigment { function { f_ridged_mf(x, y, z, 0.07, 2.2, 7, 0.8, 0.9, 2) / 3 } } }
sphere { <0, Height - 0.5, 0>, 1 pigment { function { f_ridged_mf(x, y, z, 0.3, 2.2, 8, 0.9, 0.9, 2) / 3 } } }
