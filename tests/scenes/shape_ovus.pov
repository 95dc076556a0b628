// Eggs: with the narrow end up, with it down, with equal ends, one mapped, one cut.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at <0, 0.3, 0> angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
ovus { 0.7, 0.3 translate -1.4*x pigment { rgb <1, 0.6, 0.2> } }
ovus { 0.4, 0.6 pigment { uv_mapping checker rgb <1, 0.2, 0.2>, rgb <1, 1, 0.6> scale 0.1 } }
ovus { 0.4, 0.4 rotate z * 70 translate <1.6, -0.3, 0.3> pigment { rgb <0.3, 0.7, 1> } }
difference {
	ovus { 0.6, 0.4 }
	box { <-1, -1, -1>, <0.2, 1, -0.1> }
	translate <1.1, 1, 1>
	pigment { rgb <0.5, 0.9, 0.4> }
}
