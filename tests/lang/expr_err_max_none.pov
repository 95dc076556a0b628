// max needs an argument.
#version 3.7;
#declare A = max();
