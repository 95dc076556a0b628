// A call may name another type; the spline itself keeps its own.
#version 3.7;
#declare S = spline { 0, <0, 0, 0> 1, <1, 2, 0> 3, <0, 1, 5> 4, <2, 2, 2> }
#debug concat(vstr(3, S(2), " ", 0, 6), " ", vstr(3, S(2, natural_spline), " ", 0, 6), "\n")
#debug concat(vstr(3, S(2, cubic_spline), " ", 0, 6), " ", vstr(3, S(2, quadratic_spline),
	" ", 0, 6), "\n")
#debug concat(vstr(3, S(2, linear_spline), " ", 0, 6), " ", vstr(3, S(2), " ", 0, 6), "\n")
