// A macro needs a name.
#version 3.7;
#macro (A) #end
