// A map entry's colour does not begin with '<'.
#version 3.7;
sphere { 0, 1 pigment { gradient x color_map { [0 <1, 0, 0>] [1 rgb 1] } } }
