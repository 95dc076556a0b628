// inside: with CSG, clipping and inverse; the surface counts as outside.
#version 3.7;
#declare A = difference { sphere { 0, 2 } box { 0, 5 } }
#declare B = sphere { 0, 1 inverse }
#declare C = sphere { 0, 1 clipped_by { plane { x, 0 } } }
#debug concat(str(inside(A, <-1, 0, 0>), 0, 0), str(inside(A, <1, 1, 1>), 0, 0),
	str(inside(A, <3, 0, 0>), 0, 0))
#debug concat(str(inside(B, 0), 0, 0), str(inside(B, 2), 0, 0), str(inside(C, -x/2), 0, 0),
	str(inside(C, x/2), 0, 0))
#declare S = sphere { 0, 1 }
#debug concat(str(inside(S, <0, 1, 0>), 0, 0), "\n")
