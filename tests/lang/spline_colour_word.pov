// A value is no colour in words.
#version 3.7;
#declare S = spline { 0, rgb x, 1, rgb y }
