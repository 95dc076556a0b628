#version 3.7;
#macro M(A, B) #end
M(1)
