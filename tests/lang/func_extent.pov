// min_extent and max_extent are single precision, a corner and a length.
#version 3.7;
#declare O = sphere { 0, 1 translate 1/3 }
#debug concat(vstr(3, max_extent(O), " ", 0, 11), " ", vstr(3, min_extent(O), " ", 0, 11), "\n")
#declare P = plane { y, 0 }
#debug concat(vstr(3, max_extent(P), " ", 0, 0), " ", vstr(3, min_extent(P), " ", 0, 0), "\n")
#declare U = union { cylinder { 0, 2*y, 0.5 } cone { 0, 1, -3*x, 0 } torus { 4, 0.25 } }
#debug concat(vstr(3, max_extent(U), " ", 0, 6), " ", vstr(3, min_extent(U), " ", 0, 6), "\n")
