// A linear spline: straight between the entries, still outside; the same as with no type.
#version 3.7;
#declare S = spline { linear_spline 0, <0, 0, 0> 1, <1, 2, 0> 3, <0, 1, 5> 4, <2, 2, 2> }
#declare D = spline { S }
#for (P, -1, 5, 0.75) #debug concat(vstr(3, S(P), " ", 0, 6), " ", vstr(3, D(P), " ", 0, 2),
	"\n") #end
