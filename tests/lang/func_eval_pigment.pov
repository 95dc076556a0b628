// eval_pigment of functions.inc is the colour of a pigment at a point.
#version 3.7;
#include "functions.inc"
#declare P = pigment { gradient x color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } }
#declare C = eval_pigment(P, <0.5, 0, 0>);
#debug concat(vstr(5, C, " ", 0, 6), "\n")
