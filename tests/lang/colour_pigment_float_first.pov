// A colour without a word must begin with its identifier, not with that of a float.
#version 3.7;
#declare F = 2;
#declare C = rgb 1;
sphere { 0, 1 pigment { F*C } }
