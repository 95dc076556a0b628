// lambert only: POV-Ray's answers there are chance.
// Cells of a warp beyond what an integer holds.
#include "functions.inc"
#declare P = pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] }
	warp { black_hole 0, .4 repeat <1, 1e-9, 1> turbulence <.3, .3, .3> strength 1 } }
#debug vstr(3, eval_pigment(P, <.25, 1e300, .1>), " ", 0, 3)
#debug vstr(3, eval_pigment(P, <-1e300, .1, 1e20>), " ", 0, 3)
sphere { 0, 1 }
