// Commas in an initialiser are optional and one may stand behind the last.
#version 3.7;
#declare A = array[3] { 1 2, 3, }
#declare B = array[2][2] { { 1, 2 } { 3 4 }, }
#debug concat(str(A[1] + A[2], 0, 0), str(B[1][0], 0, 0), "\n")
