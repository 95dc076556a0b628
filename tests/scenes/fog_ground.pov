// Fog near the ground, above a floor.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
fog { fog_type 2 distance 2 color rgb <0.8, 0.8, 0.9> fog_offset -0.8 fog_alt 0.3 }
cylinder { -y, 2 * y, 0.3 pigment { rgb <1, 0.4, 0.2> } }
cylinder { <1.5, -1, 4>, <1.5, 2, 4>, 0.3 pigment { rgb <0.3, 0.7, 1> } }
