// Errors and warnings of textures, one after the other.
#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 pigment { } }
sphere { 0, 1 pigment { color_map { [0 rgb 1] } } }
sphere { 0, 1 pigment { checker color_map { [0 rgb 1] } } }
sphere { 0, 1 pigment { rgb 1 color_map { [0 rgb 1] } } }
sphere { 0, 1 pigment { average } }
sphere { 0, 1 pigment { average color_map { [0 rgb 1] } } }
sphere { 0, 1 normal { average } }
sphere { 0, 1 normal { } }
sphere { 0, 1 texture { granite } }
sphere { 0, 1
	texture { granite texture_map { [0 pigment { rgb 1 }] } }
	texture { pigment { rgb 1 } }
}
sphere { 0, 1
	texture { pigment { rgb 1 } }
	texture { granite texture_map { [0 pigment { rgb 1 }] } }
}
sphere { 0, 1 finish { roughness 0 } }
sphere { 0, 1 finish { caustics 1 } }
sphere { 0, 1 finish { refraction 1 } }
sphere { 0, 1 interior { refraction 1 } }
sphere { 0, 1 pigment { julia <0, 0>, 5 exponent 99 } }
sphere { 0, 1 pigment { slope 0 } }
sphere { 0, 1 pigment { slope { y altitude y } } }
sphere { 0, 1 pigment { rgb <1, 2, 3, 4> } }
sphere { 0, 1 finish { ambient rgbt 1 } }
sphere { 0, 1 pigment { red 1 alpha 1 } }
