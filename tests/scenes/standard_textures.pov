// Textures, colours and glass from the standard includes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
#include "colors.inc"
#include "textures.inc"
#include "woods.inc"
sphere { <-1.2, 0, 0>, 0.55 texture { Polished_Chrome } }
sphere { 0, 0.55 texture { T_Wood10 scale 0.4 } }
sphere { <1.2, 0, 0>, 0.55 pigment { color Orange } finish { Shiny } }
