// A function of several components needs a selection in a body.
#version 3.7;
#declare P = function { pigment { rgb 1 } }
#declare F = function { P(x, y, z) }
