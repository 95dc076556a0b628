// Splines move objects: the extent of one put there.
#version 3.7;
#declare S = spline { cubic_spline -1, 0, 0, <0, 0, 0> 1, <4, 2, 0> 2, <8, 0, 0> 3, 0 }
#declare O = sphere { S(0.5), 1 translate S(1) }
#debug concat(vstr(3, min_extent(O), " ", 0, 4), " ", vstr(3, max_extent(O), " ", 0, 4), "\n")
