// Bounds that hold the whole object change nothing; bounded_by { clipped_by } uses the clip.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
union {
	sphere { -0.5 * x, 0.5 } box { <0.2, -0.4, -0.4>, <0.9, 0.4, 0.4> }
	bounded_by { sphere { 0.2 * x, 1.3 } }
	pigment { rgb <1, 0.6, 0.2> }
}
sphere { <1.6, 0, 0>, 0.5 clipped_by { box { <1.2, -1, -1>, <1.8, 0.3, 1> } } bounded_by { clipped_by }
	pigment { rgb <0.3, 0.7, 1> } }
