// Assigning an array copies it.
#version 3.7;
#declare A = array[2] { 1, 2 }
#declare B = A;
#declare B[0] = 9;
#debug concat(str(A[0], 0, 0), str(B[0], 0, 0), "\n")
