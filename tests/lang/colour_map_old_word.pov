// In the old form of an entry the second colour needs the word color.
#version 3.7;
sphere { 0, 1 pigment { bozo color_map { [0 1 rgb 1 rgb 0] } } }
