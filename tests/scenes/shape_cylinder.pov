// Cylinders: closed, open, and one lying.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
cylinder { <-1, -0.7, 0>, <-1, 0.7, 0>, 0.5 pigment { rgb <1, 0.6, 0.2> } }
cylinder { <0.3, -0.5, 0>, <0.3, 0.5, 0>, 0.4 open rotate x * -30 pigment { rgb <0.3, 0.7, 1> } }
cylinder { <0.8, -0.8, -0.5>, <1.8, 0.6, 0.5>, 0.2 pigment { rgb <0.7, 0.9, 0.4> } }
