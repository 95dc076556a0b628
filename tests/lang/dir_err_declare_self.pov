// A new identifier has no value yet while its value is read.
#version 3.7;
#declare A = A;
