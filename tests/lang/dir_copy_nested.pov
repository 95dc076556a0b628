// Arrays of arrays are copied in depth.
#version 3.7;
#declare A = array[2];
#declare A[0] = array[2] { 1, 2 }
#declare A[1] = array[1] { 3 }
#declare B = A;
#declare A[0][1] = 7;
#debug concat(str(A[0][1], 0, 0), str(B[0][1], 0, 0), str(B[1][0], 0, 0), "\n")
