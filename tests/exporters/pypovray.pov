// Form of PyPovray: location, look_at, sky and angle, then matrix, Reorient_Trans and translate, and `right` last of all.
#version 3.7;
#include "transforms.inc"
global_settings { assumed_gamma 1.0 }
background { rgb <0.2, 0.3, 0.4> }
camera {
 location <0, 1, -5>
 look_at <0, 0, 0>
 sky <0, 1, 0>
 angle 45
 matrix <1, 0.1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0>
 Reorient_Trans(<0, 0, 1>, <0.2, 0, 1>)
 translate <0.3, 0, 0>
 right <1.3333, 0, 0>
}
light_source { <3, 5, -4> rgb <1, 1, 1> }
sphere { <-0.4, 0, 0>, 1 pigment { rgb <0.8, 0.5, 0.2> } finish { phong 0.5 } }
box { <0.6, -1, -0.5>, <1.4, 0.2, 0.5> pigment { rgb <0.3, 0.7, 0.5> } }
