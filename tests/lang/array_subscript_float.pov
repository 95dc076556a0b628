// A subscript of a float.
#version 3.7;
#declare A = 5;
#declare F = A[1];
