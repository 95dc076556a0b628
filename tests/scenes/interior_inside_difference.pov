// The camera stands in a difference that is not hollow, without an interior: no fog there.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
fog { distance 8 rgb <0.6, 0.6, 0.7> }
difference { sphere { <0, 2, -6>, 2.4 } box { <0.5, 1, -5>, <1, 3, -3> }
	pigment { rgbt <1, 0.9, 0.8, 0.8> } }
sphere { <0.3, 0.7, 0>, 0.7 pigment { rgb 0.8 } }
