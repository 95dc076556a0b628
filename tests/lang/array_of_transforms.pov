// Transformations and splines as elements.
#version 3.7;
#declare T = array[2] { transform { translate x }, transform { scale 2 } }
#declare S = array[1] { spline { 0, x, 1, y } }
#declare O = sphere { 0, 1 transform T[1] transform { T[0] } }
#debug concat(vstr(3, max_extent(O), ",", 0, 1), " ", vstr(3, S[0](0.25), ",", 0, 2), "\n")
