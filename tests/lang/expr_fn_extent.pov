// The corners of an object's bounding box.
#version 3.7;
#declare B = box { <1, 2, 3>, <4, 6, 8> }
#declare P = plane { y, 0 }
#debug concat(vstr(3, min_extent(B), ",", 0, 3), " ", vstr(3, max_extent(B), ",", 0, 3), "\n")
