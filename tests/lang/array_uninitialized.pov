// An element that was never assigned.
#version 3.7;
#declare A = array[3]
#declare A[0] = 1;
#declare F = A[1];
