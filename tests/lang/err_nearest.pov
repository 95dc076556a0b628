#version 3.7;
#declare Colour_of_Sky = rgb x;
sphere { 0, 1 pigment { Color_of_Sky } }
