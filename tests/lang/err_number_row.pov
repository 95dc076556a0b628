// Several numbers where a vector must stand.
#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 pigment { rgb 255 128 0 } }
sphere { 0, 1 pigment { color rgb 1 0.5 0 } }
sphere { 0, 1 pigment { rgb <1, 0.5, 0> } translate 1 -2 3 }
camera { location 0 1 -5 look_at 0 }
light_source { 10 20 -10 color rgb 1 }
background { 0 0 1 }
#declare C = rgb 1 0 0;
sphere { 0, 1 pigment { color_map { [0 rgb 1 0 0] [1 rgb 1] } } }
sphere { 0, 1 finish { ambient 0.1 0.2 0.3 } }
sphere { 0 0 0 1 pigment { rgb 1 } }
box { 0, 0, 0, 1, 1, 1 }
sphere { 0, 1 finish { phong 1 2 } }
