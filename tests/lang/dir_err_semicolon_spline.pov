// Behind the name of a spline, which could be called, a semicolon is needed.
#version 3.7;
#declare S = spline { 0, x 1, y }
#declare T = S
sphere { 0, 1 }
