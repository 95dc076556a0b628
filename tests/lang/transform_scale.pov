// scale: 0 counts as 1, a float is uniform, a negative one mirrors.
#version 3.7;
#declare O = box { 0, 1 scale <2, 0, -3> }
#debug concat(vstr(3, min_extent(O), " ", 0, 4), " ", vstr(3, max_extent(O), " ", 0, 4), "\n")
#declare O = box { 0, 1 scale 2 }
#debug concat(vstr(3, min_extent(O), " ", 0, 4), " ", vstr(3, max_extent(O), " ", 0, 4), "\n")
