// A box with round holes; the inside of a hole has the pigment of what was taken away.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
difference {
	box { -0.8, 0.8 pigment { rgb <1, 0.6, 0.2> } }
	sphere { <0, 0.2, -0.8>, 0.6 pigment { rgb <0.3, 0.7, 1> } }
	cylinder { -y, y, 0.4 translate x * 0.5 }
	pigment { rgb 0.8 }
	rotate <-15, 30, 0>
}
