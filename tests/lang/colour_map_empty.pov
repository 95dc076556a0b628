// A colour map has at least one entry.
#version 3.7;
sphere { 0, 1 pigment { gradient x color_map { } } }
