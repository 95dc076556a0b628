// The camera is in an object that no lamp is in.
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <5, 5, -5>, 1 }
plane { y, -1 pigment { rgb 1 } }
difference { box { -3, 3 } box { 2, 3 } pigment { rgb 1 } }
camera { location 0 look_at z }
