// Too many arguments.
#version 3.7;
#macro M(A) #end
M(1, 2)
