// There is no % operator.
#version 3.7;
#declare A = 7 % 2;
