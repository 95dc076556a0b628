// The name of a macro cannot be declared.
#version 3.7;
#macro M() #end
#declare M = 5;
