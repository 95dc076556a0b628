// Direction, right and up given by hand; a left-handed right vector; sky tilted.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> direction 1.8 * z right -1.5 * x up 1.1 * y sky <0.2, 1, 0> look_at <0.3, 0, 0> }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
sphere { 0, 1 pigment { rgb <1, 0.6, 0.2> } }
box { <1, -1, 0>, <2, 0, 1> pigment { rgb <0.3, 0.7, 1> } }
