// translate adds; a float goes to all three components.
#version 3.7;
#declare O = box { 0, 1 translate <1, 2, 3> translate 0.5 }
#debug concat(vstr(3, min_extent(O), " ", 0, 4), " ", vstr(3, max_extent(O), " ", 0, 4), "\n")
