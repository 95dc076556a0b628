// Planes: a floor, and a tilted one with a distance.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { rgb <0.5, 0.7, 0.3> } }
plane { <1, 1, -2>, -3 pigment { rgb <0.6, 0.5, 0.8> } }
