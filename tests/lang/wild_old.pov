// Version 3.0: no semicolons, comparisons of colours by the old includes.
#version 3.0
#include "colors.inc"
#include "textures.inc"
#declare X = 5
#declare Y1 = X * 2
#declare Text = concat("y = ", str(Y1, 0, 0), "\n")
sphere { <0, 0, 0>, 1 texture { Gold_Metal } }
plane { y, -1 pigment { checker color White color Black } }
#debug Text
