#version 3.7;
#declare A = array[2];
#declare B = A[1];
