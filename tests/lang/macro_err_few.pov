// Too few arguments.
#version 3.7;
#macro M(A, B, C) #end
M(1, 2)
