// The vector tools of math.inc.
#version 3.7;
#include "math.inc"
#debug concat(str(VAngleD(x, x + y), 0, 6), " ", vstr(3, VProject_Plane(<1, 2, 3>, y),
	" ", 0, 4), "\n")
#debug concat(vstr(3, VPerp_To_Vector(<1, 2, 3>), " ", 0, 6), "\n")
#debug concat(str(clamp(5.5, 0, 2), 0, 3), " ", str(adj_range(0.5, 2, 4), 0, 3), " ",
	str(sgn(-3), 0, 1), "\n")
