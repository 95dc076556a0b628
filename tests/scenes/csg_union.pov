// A union: members keep their own pigment or take that of the whole.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
union {
	sphere { <-0.6, 0, 0>, 0.6 }
	sphere { <0.2, 0.2, 0>, 0.6 pigment { rgb <0.3, 0.7, 1> } }
	union { box { <0.6, -0.6, -0.3>, <1.2, 0, 0.3> } cylinder { 0.9 * x, <0.9, 0.8, 0>, 0.2 } rotate z * -10 }
	pigment { rgb <1, 0.6, 0.2> }
	rotate y * 20
}
