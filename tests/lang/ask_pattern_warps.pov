// Warps and waves in functions of patterns.
#version 3.7;
#include "functions.inc"
#include "ask.inc"
#declare F = function { pattern { wood warp { repeat x flip z } scale 0.7 } }
AskPattern(F)
#undef F
#declare P = pigment { gradient x warp { repeat x flip z } rotate 10 }
AskPigment(P)
#declare F = function { pattern { wood warp { black_hole <0.3,0.2,0>, 1 falloff 2 strength 0.8 } scale 0.7 } }
AskPattern(F)
#undef F
#declare P = pigment { gradient x warp { black_hole <0.3,0.2,0>, 1 falloff 2 strength 0.8 } rotate 10 }
AskPigment(P)
#declare F = function { pattern { wood warp { spherical orientation y } scale 0.7 } }
AskPattern(F)
#undef F
#declare P = pigment { gradient x warp { spherical orientation y } rotate 10 }
AskPigment(P)
#declare F = function { pattern { wood warp { cylindrical } scale 0.7 } }
AskPattern(F)
#undef F
#declare P = pigment { gradient x warp { cylindrical } rotate 10 }
AskPigment(P)
#declare F = function { pattern { wood warp { toroidal dist_exp 1 } scale 0.7 } }
AskPattern(F)
#undef F
#declare P = pigment { gradient x warp { toroidal dist_exp 1 } rotate 10 }
AskPigment(P)
#declare F = function { pattern { wood warp { planar z, 0.3 } scale 0.7 } }
AskPattern(F)
#undef F
#declare P = pigment { gradient x warp { planar z, 0.3 } rotate 10 }
AskPigment(P)
#declare F = function { pattern { wood warp { cubic } scale 0.7 } }
AskPattern(F)
#undef F
#declare P = pigment { gradient x warp { cubic } rotate 10 }
AskPigment(P)
#declare F = function { pattern { wood warp { turbulence <0.3,0.2,0.5> octaves 4 lambda 1.8 omega 0.6 } scale 0.7 } }
AskPattern(F)
#undef F
#declare P = pigment { gradient x warp { turbulence <0.3,0.2,0.5> octaves 4 lambda 1.8 omega 0.6 } rotate 10 }
AskPigment(P)
#declare F = function { pattern { spherical ramp_wave frequency 3 phase 0.3 } }
AskPattern(F)
#undef F
#declare F = function { pattern { spherical triangle_wave frequency 3 phase 0.3 } }
AskPattern(F)
#undef F
#declare F = function { pattern { spherical sine_wave frequency 3 phase 0.3 } }
AskPattern(F)
#undef F
#declare F = function { pattern { spherical scallop_wave frequency 3 phase 0.3 } }
AskPattern(F)
#undef F
#declare F = function { pattern { spherical cubic_wave frequency 3 phase 0.3 } }
AskPattern(F)
#undef F
#declare F = function { pattern { spherical poly_wave 3 frequency 3 phase 0.3 } }
AskPattern(F)
#undef F
