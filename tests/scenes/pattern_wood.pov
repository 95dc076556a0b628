// Wood with and without turbulence.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
box { <-1.8, -0.8, 0>, <-0.1, 0.8, 1> pigment { wood scale 0.3
	color_map { [0 rgb <0.7, 0.5, 0.3>] [0.8 rgb <0.4, 0.2, 0.1>] [1 rgb <0.3, 0.15, 0.1>] } } }
box { <0.1, -0.8, 0>, <1.8, 0.8, 1> pigment { wood turbulence <0.1, 0.2, 0> octaves 3 scale 0.3 rotate <5, 80, 0>
	color_map { [0 rgb <0.7, 0.5, 0.3>] [1 rgb <0.3, 0.15, 0.1>] } } }
