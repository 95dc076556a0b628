// Only arrays have elements.
#version 3.7;
#declare A = 5;
#declare A[0] = 6;
