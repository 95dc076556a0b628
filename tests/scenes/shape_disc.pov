// Discs: a full one, and one with a hole.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
disc { <-0.9, 0, 0>, <0.2, 0.3, -1>, 0.8 pigment { rgb <1, 0.6, 0.2> } }
disc { <0.9, 0, 0>, <-0.4, 0.6, -1>, 0.8, 0.3 pigment { rgb <0.3, 0.7, 1> } }
