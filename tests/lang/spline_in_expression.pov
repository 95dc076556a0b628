// A call of a spline is a vector: components, sums and arguments.
#version 3.7;
#declare S = spline { 0, <1, 2, 3> 1, <3, 2, 1> }
#declare V = 2*S(0.5) + S(S(0).x);
#debug concat(vstr(3, V, " ", 0, 3), " ", str(S(0.25).z, 0, 3), " ", str(vlength(S(0)), 0, 5), "\n")
