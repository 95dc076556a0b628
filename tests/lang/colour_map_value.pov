// The entries of a colour map, old and new form, with and without commas after the position.
#version 3.7;
#declare M = color_map { [0 rgb 0] [0.5, rgb x] [0.5 0.75 color rgb y color rgb z] [1 color red 1] }
#declare C = rgb 0.5;
#declare N = color_map { [0.5 0.3*C] [1, C] }
#declare F = function { pigment { gradient x color_map { M } } }
#debug concat(vstr(5, F(0.25, 0, 0), " ", 0, 6), "\n")
#debug concat(vstr(5, F(0.625, 0, 0), " ", 0, 6), "\n")
#declare G = function { pigment { gradient x color_map { N } } }
#debug concat(vstr(5, G(0.75, 0, 0), " ", 0, 6), "\n")
