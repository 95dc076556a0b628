// log of a negative value.
#version 3.7;
#declare A = log(-1);
