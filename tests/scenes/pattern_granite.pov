// Granite, plain and scaled.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { -x, 0.8 pigment { granite } }
sphere { x, 0.8 pigment { granite scale 0.4 turbulence 0.2 color_map { [0 rgb <0.3, 0.1, 0>] [1 rgb <1, 0.9, 0.8>] } } }
