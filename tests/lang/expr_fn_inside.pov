// inside tells whether a point is in an object, with transformations, CSG and inverse.
#version 3.7;
#declare S = sphere { 0, 1 translate 2*x }
#declare D = difference { box { -1, 1 } sphere { 0, 0.5 } }
#declare I = sphere { 0, 1 inverse }
#debug concat(str(inside(S, 2.5*x), 0, 0), str(inside(S, 0), 0, 0), str(inside(D, 0.9), 0, 0),
	str(inside(D, 0), 0, 0),
	str(inside(I, 0), 0, 0), str(inside(I, 2*x), 0, 0), "\n")
