// A reserved word cannot be the name of a macro.
#version 3.7;
#macro sphere(A) #end
