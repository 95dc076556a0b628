// A string must be followed by a relation.
#version 3.7;
#declare S = "x";
#if (S) #end
