// Triangles and polygons.
#version 3.7;
triangle { 0, x, y }
smooth_triangle { 0, z, x, z, y, z }
polygon { 4, 0, x, x + y, 0 }
#debug "ok\n"
