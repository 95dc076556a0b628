// An inverted sphere in an intersection is a difference; nested differences.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
intersection {
	box { -0.7, 0.7 } sphere { <0.5, 0.6, -0.6>, 0.8 inverse }
	rotate y * 20 translate -0.9 * x pigment { rgb <1, 0.6, 0.2> }
}
difference {
	difference { sphere { 0, 0.8 } box { <-1, -1, -1>, <0, 1, 0> } }
	difference { sphere { 0, 0.6 } sphere { 0, 0.3 } }
	rotate y * 30 translate 0.9 * x pigment { rgb <0.3, 0.7, 1> }
}
