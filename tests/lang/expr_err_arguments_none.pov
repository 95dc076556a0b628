// A function needs its parentheses.
#version 3.7;
#declare A = sin 5;
