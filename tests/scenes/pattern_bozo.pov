// Bozo with turbulence, and with each noise generator.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { <-1.1, 0, 0>, 0.5 pigment { bozo scale 0.2 } }
sphere { 0, 0.5 pigment { bozo turbulence 0.6 octaves 4 omega 0.6 lambda 2.2 scale 0.3
	color_map { [0.3 rgb <0.1, 0.3, 1>] [0.7 rgb 1] } } }
sphere { <1.1, 0, 0>, 0.5 pigment { bozo noise_generator 1 scale 0.2 } }
sphere { <0, 1, 0>, 0.4 pigment { bozo noise_generator 3 scale 0.2 } }
