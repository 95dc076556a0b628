// The first word of an expression where a string is wanted is named.
#version 3.7;
#declare R = seed(1);
#declare A = strlen(rand(R));
