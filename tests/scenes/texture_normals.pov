// Every pattern as a normal.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3.5, 2.5, -10> right 8*x up 6*y direction z }
light_source { <-20, 30, -40>, 1 }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { agate bump_size .4 scale .17 rotate 20 } translate <0, 0, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { bozo bump_size .4 scale .17 rotate 20 } translate <1, 0, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { boxed bump_size .4 scale .17 rotate 20 } translate <2, 0, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { brick brick_size <2,1,1> mortar .1 bump_size .4 scale .17 rotate 20 } translate <3, 0, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { bumps bump_size .4 scale .17 rotate 20 } translate <4, 0, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { cells bump_size .4 scale .17 rotate 20 } translate <5, 0, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { checker bump_size .4 scale .17 rotate 20 } translate <6, 0, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { crackle form <.3,.5,-.2> metric 3 bump_size .4 scale .17 rotate 20 } translate <7, 0, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { crackle solid bump_size .4 scale .17 rotate 20 } translate <0, 1, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { cubic bump_size .4 scale .17 rotate 20 } translate <1, 1, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { cylindrical bump_size .4 scale .17 rotate 20 } translate <2, 1, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { dents bump_size .4 scale .17 rotate 20 } translate <3, 1, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { granite bump_size .4 scale .17 rotate 20 } translate <4, 1, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { hexagon bump_size .4 scale .17 rotate 20 } translate <5, 1, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { leopard frequency 3 bump_size .4 scale .17 rotate 20 } translate <6, 1, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { marble bump_size .4 scale .17 rotate 20 } translate <7, 1, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { onion bump_size .4 scale .17 rotate 20 } translate <0, 2, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { planar bump_size .4 scale .17 rotate 20 } translate <1, 2, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { quilted control0 .2 control1 1.7 bump_size .4 scale .17 rotate 20 } translate <2, 2, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { radial bump_size .4 scale .17 rotate 20 } translate <3, 2, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { ripples frequency 4 bump_size .4 scale .17 rotate 20 } translate <4, 2, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { spherical bump_size .4 scale .17 rotate 20 } translate <5, 2, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { spotted bump_size .4 scale .17 rotate 20 } translate <6, 2, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { waves bump_size .4 scale .17 rotate 20 } translate <7, 2, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { wood bump_size .4 scale .17 rotate 20 } translate <0, 3, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { wrinkles bump_size .4 scale .17 rotate 20 } translate <1, 3, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { gradient <1,2,-.5> bump_size .4 scale .17 rotate 20 } translate <2, 3, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { spiral1 3 bump_size .4 scale .17 rotate 20 } translate <3, 3, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { spiral2 5 bump_size .4 scale .17 rotate 20 } translate <4, 3, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { mandel 20 bump_size .4 scale .17 rotate 20 } translate <5, 3, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { julia <.3,.4>, 15 exponent 4 interior 1,1 bump_size .4 scale .17 rotate 20 } translate <6, 3, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { magnet 2 mandel 20 exterior 5,.01 bump_size .4 scale .17 rotate 20 } translate <7, 3, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { square bump_size .4 scale .17 rotate 20 } translate <0, 4, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { triangular bump_size .4 scale .17 rotate 20 } translate <1, 4, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { slope <1,1,-1> bump_size .4 scale .17 rotate 20 } translate <2, 4, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { slope { <1,1,-1>, .2, .9 altitude y, -1, 1 } bump_size .4 scale .17 rotate 20 } translate <3, 4, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { slope { point_at <0,3,-3> } bump_size .4 scale .17 rotate 20 } translate <4, 4, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { aoi bump_size .4 scale .17 rotate 20 } translate <5, 4, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { object { sphere { 0, .4 } } bump_size .4 scale .17 rotate 20 } translate <6, 4, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { pigment_pattern { bozo scale .3 } bump_size .4 scale .17 rotate 20 } translate <7, 4, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { function { x*x + y*z } bump_size .4 scale .17 rotate 20 } translate <0, 5, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { bozo turbulence .5 lambda 2.5 octaves 4 bump_size .4 scale .17 rotate 20 } translate <1, 5, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { marble turbulence .4 bump_size .4 scale .17 rotate 20 } translate <2, 5, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { wood turbulence .1 omega .7 bump_size .4 scale .17 rotate 20 } translate <3, 5, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { agate agate_turb 2 turbulence .3 bump_size .4 scale .17 rotate 20 } translate <4, 5, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { bozo noise_generator 1 bump_size .4 scale .17 rotate 20 } translate <5, 5, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { bozo noise_generator 3 bump_size .4 scale .17 rotate 20 } translate <6, 5, 0> }
sphere { 0, .48 pigment { rgb <1, .8, .6> } normal { granite poly_wave 2 bump_size .4 scale .17 rotate 20 } translate <7, 5, 0> }
