// In the old form of an entry no comma stands before the first colour.
#version 3.7;
sphere { 0, 1 pigment { bozo color_map { [0, 1, color rgb 1 color rgb 0] } } }
