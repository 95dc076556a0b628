// Every pattern as a pigment.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3.5, 2.5, -10> right 8*x up 6*y direction z }
light_source { <-20, 30, -40>, 1 }
sphere { 0, .48 pigment { agate scale .3 } translate <0, 0, 0> }
sphere { 0, .48 pigment { bozo scale .3 } translate <1, 0, 0> }
sphere { 0, .48 pigment { boxed scale .3 } translate <2, 0, 0> }
sphere { 0, .48 pigment { brick brick_size <2,1,1> mortar .1 scale .3 } translate <3, 0, 0> }
sphere { 0, .48 pigment { bumps scale .3 } translate <4, 0, 0> }
sphere { 0, .48 pigment { cells scale .3 } translate <5, 0, 0> }
sphere { 0, .48 pigment { checker scale .3 } translate <6, 0, 0> }
sphere { 0, .48 pigment { crackle form <.3,.5,-.2> metric 3 scale .3 } translate <7, 0, 0> }
sphere { 0, .48 pigment { crackle solid scale .3 } translate <0, 1, 0> }
sphere { 0, .48 pigment { cubic scale .3 } translate <1, 1, 0> }
sphere { 0, .48 pigment { cylindrical scale .3 } translate <2, 1, 0> }
sphere { 0, .48 pigment { dents scale .3 } translate <3, 1, 0> }
sphere { 0, .48 pigment { granite scale .3 } translate <4, 1, 0> }
sphere { 0, .48 pigment { hexagon scale .3 } translate <5, 1, 0> }
sphere { 0, .48 pigment { leopard frequency 3 scale .3 } translate <6, 1, 0> }
sphere { 0, .48 pigment { marble scale .3 } translate <7, 1, 0> }
sphere { 0, .48 pigment { onion scale .3 } translate <0, 2, 0> }
sphere { 0, .48 pigment { planar scale .3 } translate <1, 2, 0> }
sphere { 0, .48 pigment { quilted control0 .2 control1 1.7 scale .3 } translate <2, 2, 0> }
sphere { 0, .48 pigment { radial scale .3 } translate <3, 2, 0> }
sphere { 0, .48 pigment { ripples frequency 4 scale .3 } translate <4, 2, 0> }
sphere { 0, .48 pigment { spherical scale .3 } translate <5, 2, 0> }
sphere { 0, .48 pigment { spotted scale .3 } translate <6, 2, 0> }
sphere { 0, .48 pigment { waves scale .3 } translate <7, 2, 0> }
sphere { 0, .48 pigment { wood scale .3 } translate <0, 3, 0> }
sphere { 0, .48 pigment { wrinkles scale .3 } translate <1, 3, 0> }
sphere { 0, .48 pigment { gradient <1,2,-.5> scale .3 } translate <2, 3, 0> }
sphere { 0, .48 pigment { spiral1 3 scale .3 } translate <3, 3, 0> }
sphere { 0, .48 pigment { spiral2 5 scale .3 } translate <4, 3, 0> }
sphere { 0, .48 pigment { mandel 20 scale .3 } translate <5, 3, 0> }
sphere { 0, .48 pigment { julia <.3,.4>, 15 exponent 4 interior 1,1 scale .3 } translate <6, 3, 0> }
sphere { 0, .48 pigment { magnet 2 mandel 20 exterior 5,.01 scale .3 } translate <7, 3, 0> }
sphere { 0, .48 pigment { square scale .3 } translate <0, 4, 0> }
sphere { 0, .48 pigment { triangular scale .3 } translate <1, 4, 0> }
sphere { 0, .48 pigment { slope <1,1,-1> scale .3 } translate <2, 4, 0> }
sphere { 0, .48 pigment { slope { <1,1,-1>, .2, .9 altitude y, -1, 1 } scale .3 } translate <3, 4, 0> }
sphere { 0, .48 pigment { slope { point_at <0,3,-3> } scale .3 } translate <4, 4, 0> }
sphere { 0, .48 pigment { aoi scale .3 } translate <5, 4, 0> }
sphere { 0, .48 pigment { object { sphere { 0, .4 } } scale .3 } translate <6, 4, 0> }
sphere { 0, .48 pigment { pigment_pattern { bozo scale .3 } scale .3 } translate <7, 4, 0> }
sphere { 0, .48 pigment { function { x*x + y*z } scale .3 } translate <0, 5, 0> }
sphere { 0, .48 pigment { bozo turbulence .5 lambda 2.5 octaves 4 scale .3 } translate <1, 5, 0> }
sphere { 0, .48 pigment { marble turbulence .4 scale .3 } translate <2, 5, 0> }
sphere { 0, .48 pigment { wood turbulence .1 omega .7 scale .3 } translate <3, 5, 0> }
sphere { 0, .48 pigment { agate agate_turb 2 turbulence .3 scale .3 } translate <4, 5, 0> }
sphere { 0, .48 pigment { bozo noise_generator 1 scale .3 } translate <5, 5, 0> }
sphere { 0, .48 pigment { bozo noise_generator 3 scale .3 } translate <6, 5, 0> }
sphere { 0, .48 pigment { granite poly_wave 2 scale .3 } translate <7, 5, 0> }
