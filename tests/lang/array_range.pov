// A subscript beyond the last element.
#version 3.7;
#declare A = array[3] { 1, 2, 3 }
#declare F = A[3];
