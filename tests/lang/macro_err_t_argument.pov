// Nor can an argument of a macro.
#version 3.7;
#macro M(A, B) #end
M(1, t)
