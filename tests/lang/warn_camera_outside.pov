// The camera is in nothing, or in what is not dark within: no warning.
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <5, 5, -5>, 1 }
light_source { 9*y, 1 shadowless }
plane { y, 0 pigment { rgb 1 } }
sphere { 0, 100 pigment { rgb 1 } }
sphere { 0, 2 hollow pigment { rgb 1 } finish { ambient 1 diffuse 0 } }
sphere { 0, 2 pigment { rgbt <1, 1, 1, 0.8> } }
sphere { 0, 2 pigment { rgb 1 } no_image }
difference { sphere { 0, 2 } sphere { 0, 1 } pigment { rgb 1 } }
camera { location 0 look_at z }
