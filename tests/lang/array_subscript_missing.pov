// An element needs all subscripts.
#version 3.7;
#declare A = array[2][2] { { 1, 2 }, { 3, 4 } }
#declare F = A[1] + 1;
