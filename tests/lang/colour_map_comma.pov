// No commas stand between the entries of a colour map.
#version 3.7;
sphere { 0, 1 pigment { gradient x color_map { [0 rgb 0], [1 rgb 1] } } }
