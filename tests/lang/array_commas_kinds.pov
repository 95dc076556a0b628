// The same for strings and vectors.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = array[2] { "a" "b", }
#declare B = array[2] { <1, 2, 3> <4, 5, 6> }
#declare C = array[2][2] { { 1 2 } { 3, 4, } }
#debug concat(A[0], A[1], str(B[1].y, 0, 0), str(C[0][1] + C[1][1], 0, 0), "\n")
sphere { 0, 1 }
