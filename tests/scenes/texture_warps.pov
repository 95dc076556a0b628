// Warps, in their order among the transformations.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.2, -4> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
sphere { <-1.1, 0, 0>, 1 pigment { checker scale .1 warp { spherical orientation y dist_exp 1 } rotate 30 } }
sphere { <1.1, 0, 0>, 1 pigment { bozo scale .3 warp { turbulence .5 octaves 3 } warp { toroidal orientation y } } }
plane { y, -1.01 pigment { hexagon scale .2 warp { repeat x*1.1 flip y offset z*.2 }
	warp { black_hole <.3, -1, .3>, .8 repeat <2, 0, 2> turbulence <.2, 0, .2> strength 1.5 }
	warp { turbulence .2 } rotate y*20 } }
plane { z, 3 pigment { checker scale .3 warp { cylindrical orientation z dist_exp .5 } warp { planar y, .3 } } }
