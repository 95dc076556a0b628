// A lens, a quarter of a sphere cut by planes, and an empty intersection.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
intersection {
	sphere { <-0.4, 0, 0>, 0.8 } sphere { <0.4, 0, 0>, 0.8 }
	rotate y * 60 translate -0.9 * x pigment { rgb <1, 0.6, 0.2> }
}
intersection {
	sphere { 0, 0.8 } plane { x, 0.2 pigment { rgb <0.3, 1, 0.5> } } plane { -z, 0.3 } plane { y, 0.4 inverse }
	rotate y * 30 translate 0.9 * x pigment { rgb <0.3, 0.7, 1> }
}
intersection { sphere { -3 * x, 1 } sphere { 3 * x, 1 } pigment { rgb <1, 0, 0> } }
