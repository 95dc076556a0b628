// A quadratic spline: the parabola through three entries.
#version 3.7;
#declare S = spline { quadratic_spline 0, <0, 0, 0> 1, <1, 2, 0> 3, <0, 1, 5> 4, <2, 2, 2> }
#for (P, -1, 5, 0.75) #debug concat(vstr(3, S(P), " ", 0, 6), "\n") #end
#debug concat(vstr(3, S(2), " ", 0, 6), " ", vstr(3, S(1), " ", 0, 6), " ", vstr(3, S(3),
	" ", 0, 6), "\n")
