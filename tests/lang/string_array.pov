// Arrays of strings, their elements in any place of a string.
#version 3.7;
#declare A = array[3] { "x", "yy", concat("z", "z", "z") }
#declare B = A
#declare A[0] = "changed";
#debug concat(A[0], B[0], A[2], str(strlen(A[1]), 0, 0), strupr(B[1]), "\n")
