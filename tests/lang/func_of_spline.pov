// A function of a spline has one parameter and as many components as it.
#version 3.7;
#declare S = spline { natural_spline 0, <0, 0, 0> 1, <1, 2, 0> 3, <0, 1, 5> 4, <2, 2, 2> }
#declare F = function { spline { S } }
#declare G = function(x) { F(x).x + 10*F(x).y + 100*F(x).z }
#debug concat(vstr(3, F(2), " ", 0, 6), " ", str(G(2), 0, 6), "\n")
