// A spline has as many components as its longest value, two at least; a float is doubled.
#version 3.7;
#declare S = spline { 0, 5, 1, 7 }
#debug concat(vstr(5, S(0.5), " ", 0, 2), "\n")
#declare T = spline { 0, <1, 2, 3, 4> 1, <5, 6, 7, 8> }
#debug concat(vstr(5, T(0.5), " ", 0, 2), " ", str(T(0.5).t, 0, 2), "\n")
#declare C = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;
#declare U = spline { 0, C, 1, C*2 }
#debug concat(vstr(5, U(0.5), " ", 0, 3), "\n")
