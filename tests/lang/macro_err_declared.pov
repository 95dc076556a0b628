// The name of another identifier cannot become that of a macro.
#version 3.7;
#declare M = 5;
#macro M() #end
