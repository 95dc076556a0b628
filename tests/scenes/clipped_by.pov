// Clipping shows the inside of a hollow shell; it makes no lid.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { 0, 0.8 clipped_by { plane { y, 0.3 } } rotate x * -20 translate -0.9 * x pigment { rgb <1, 0.6, 0.2> } }
box { -0.6, 0.6 clipped_by { sphere { 0, 0.8 } } rotate y * 30 translate 0.9 * x pigment { rgb <0.3, 0.7, 1> } }
