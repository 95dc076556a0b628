// At sum level < opens a vector and > closes it.
#version 3.7;
#declare A = 2;
box { <-1, -A, -1> <1, A, 1> }
#declare B = box { <-1, -A, -1> <1, A, 1> }
#debug concat(vstr(3, max_extent(B) - min_extent(B), ",", 0, 3), "\n")
