// Pigments of pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
sphere { <-1.1, 0, 0>, 1 pigment { gradient y
	pigment_map { [.2 checker scale .1] [.5 bozo scale .1] [.8 color rgb x] } turbulence .5 } }
sphere { <1.1, 0, 0>, 1 pigment { hexagon pigment { bozo scale .1 } pigment { rgb x } scale .3 } }
plane { y, -1.01 pigment { average pigment_map { [1 checker] [2 bozo scale .3 rotate 30] [1 rgb <.2, .5, .2>] } } }
plane { z, 3 pigment { marble scallop_wave scale .5
	color_map { [0 rgb 0] [.2 rgb 1] [.4, .5 color rgb x color rgb y] [.7, .9 color rgb z color rgb 1] } } }
