// A right-handed world with z up.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, -4, 2> sky z right -4/3 * x look_at <0.5, 0, 0.4> angle 35 }
light_source { <5, -6, 8> rgb 1 }
plane { z, 0 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
sphere { <0, 0, 0.5>, 0.5 pigment { rgb <1, 0, 0> } }
cylinder { <1, 0, 0>, <1, 0, 1>, 0.2 pigment { rgb <0, 1, 0> } }
