// A cubic spline holds still in its first and its last interval.
#version 3.7;
#declare S = spline { cubic_spline 0, <0, 0, 0> 1, <1, 2, 0> 3, <0, 1, 5> 4, <2, 2, 2> 6, <1, 0, 1> }
#for (P, -1, 7, 0.5) #debug concat(vstr(3, S(P), " ", 0, 6), "\n") #end
