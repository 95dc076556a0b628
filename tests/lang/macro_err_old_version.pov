// Macros need version 3.1.
#version 3.0;
#macro M() #end
