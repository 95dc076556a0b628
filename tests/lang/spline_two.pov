// Two entries: quadratic and natural splines are straight.
#version 3.7;
#declare S = spline { quadratic_spline 0, <0, 0, 0> 2, <1, 2, 0> }
#declare T = spline { natural_spline 0, <0, 0, 0> 2, <1, 2, 0> }
#for (P, -1, 3, 0.5) #debug concat(vstr(3, S(P), " ", 0, 6), " ", vstr(3, T(P), " ", 0, 6),
	"\n") #end
