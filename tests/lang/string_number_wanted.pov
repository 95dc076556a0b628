// A string is not turned into a number by itself.
#version 3.7;
#declare S = "5";
#declare F = sin(S);
