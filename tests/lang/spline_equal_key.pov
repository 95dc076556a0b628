// An equal key replaces the entry, but not the last one.
#version 3.7;
#declare S = spline { 0, <0, 0, 0> 1, <1, 0, 0> 2, <2, 0, 0> 1, <5, 0, 0> 2, <7, 0, 0> 0, <9, 0, 0> }
#debug concat(str(S(0).x, 0, 3), " ", str(S(1).x, 0, 3), " ", str(S(2).x, 0, 3), "\n")
#declare T = spline { 1, <1, 0, 0> 1, <2, 0, 0> }
#debug concat(str(T(0).x, 0, 3), " ", str(T(1).x, 0, 3), " ", str(T(2).x, 0, 3), "\n")
