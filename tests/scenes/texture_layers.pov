// Layers; modifying the top one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
#declare T = texture { pigment { wood scale .2 turbulence .1 } }
	texture {
		pigment { bozo color_map { [.3 rgbt 1] [.5 rgbf <.8, .5, .4, .7>] [.8 rgb <.2, .4, .6>] } scale .3 }
		finish { phong 1 reflection .2 }
	}
#declare U = texture { T pigment { checker rgbt 1 rgb z scale .2 } rotate 30 scale 2 }
sphere { 0, 1 texture { T } texture { U } scale .9 }
plane { y, -1 texture { pigment { checker } } texture { U } normal { bumps 1 } }
