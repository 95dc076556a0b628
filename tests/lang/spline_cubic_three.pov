// A cubic spline of three entries is its middle one everywhere; of two it is their mean.
#version 3.7;
#declare S = spline { cubic_spline 0, <0, 0, 0> 1, <1, 2, 0> 3, <0, 1, 5> }
#declare T = spline { cubic_spline 0, <0, 0, 0> 1, <1, 2, 0> }
#for (P, -1, 4, 1.25) #debug concat(vstr(3, S(P), " ", 0, 4), " ", vstr(3, T(P), " ", 0, 4),
	"\n") #end
