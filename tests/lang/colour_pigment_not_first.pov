// A colour without a word must begin with its identifier.
#version 3.7;
#declare C = rgb 1;
sphere { 0, 1 pigment { 0.5*C } }
