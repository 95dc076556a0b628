// Normals from maps, lists, averages and slopes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
sphere { <-1.1, 0, 0>, 1 pigment { rgb 1 }
	normal { gradient y normal_map { [.2 bumps 1 scale .1] [.5 dents 2 scale .2] [.8 wrinkles 1] } rotate 20 } }
sphere { <1.1, 0, 0>, 1 pigment { rgb 1 }
	normal { average normal_map { [1 gradient x scale .2] [2 ripples 1 scale .3] } scale <1, 2, 1> } }
sphere { <0, 1.2, 1>, .7 pigment { rgb 1 } normal { granite .3 scale 2 no_bump_scale accuracy .1 bump_size .2 } }
plane { y, -1.01 pigment { rgb 1 } normal { checker normal { bumps 1 scale .1 } normal { ripples 1 scale .3 } } }
plane { z, 3 pigment { rgb 1 }
	normal { wood .6 slope_map { [0 <0, 1>] [.5 <1, 1>] [.5 <1, -1>] [1 <0, -1>] } scale .4 turbulence .1 } }
