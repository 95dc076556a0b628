// A spline that starts from another takes its entries and its type, and may add to them.
#version 3.7;
#declare S = spline { natural_spline 0, <0, 0, 0> 1, <1, 2, 0> 3, <0, 1, 5> }
#declare T = spline { S 4, <2, 2, 2> }
#declare U = spline { S quadratic_spline 4, <2, 2, 2> }
#debug concat(vstr(3, S(2), " ", 0, 6), " ", vstr(3, T(2), " ", 0, 6), " ", vstr(3, U(2),
	" ", 0, 6), "\n")
#declare V = S;
#debug concat(vstr(3, V(0.5), " ", 0, 6), "\n")
