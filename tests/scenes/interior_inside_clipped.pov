// The camera stands in a sphere, where the clip has cut it away: still inside, as in POV-Ray.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0> right x * 4 / 3 angle 45 }
light_source { <3, 5, -4> rgb <1, 0.9, 0.8> }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.1> } }
background { rgb <0.1, 0.2, 0.4> }
fog { distance 8 rgb <0.6, 0.6, 0.7> }
sphere { <0, 2, -6>, 2.4 clipped_by { plane { -z, 5 } }
	pigment { rgbt <1, 0.9, 0.8, 0.8> } interior { ior 1.2 fade_distance 1 fade_power 2 } }
sphere { <0.3, 0.7, 0>, 0.7 pigment { rgb 0.8 } }
