// Textures at uv coordinates.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
sphere { <-1.1, 0, 0>, 1 uv_mapping pigment { checker scale .1 } rotate 30 }
torus { .8, .2 pigment { uv_mapping gradient x color_map { [.5 rgb 1] [.5 rgb 0] } scale .1 } rotate -60*x translate <1.1, 0, 0> }
sphere { <0, 1.2, 1>, .7 pigment { uv_mapping checker scale .3 } normal { uv_mapping bumps 1 scale .05 } }
plane { y, -1.01 texture { uv_mapping radial texture_map { [.3 pigment { granite }] [.6 pigment { rgb x }] } } }
