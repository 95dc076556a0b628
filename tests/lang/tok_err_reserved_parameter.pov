// A reserved word cannot be a macro parameter.
#version 3.7;
#macro M(radius) #end
