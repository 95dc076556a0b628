// Behind a string one semicolon is taken at most.
#version 3.7;
#declare A = "string";;
