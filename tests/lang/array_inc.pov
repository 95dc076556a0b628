// The tools of arrays.inc: sorting, reversing, resizing.
#version 3.7;
#include "arrays.inc"
#declare A = array[5] { 3, 1, 5, 2, 4 }
Sort_Array(A)
#debug concat(str(A[0], 0, 0), str(A[2], 0, 0), str(A[4], 0, 0), " ")
Reverse_Array(A)
#debug concat(str(A[0], 0, 0), str(A[4], 0, 0), " ")
Resize_Array(A, 7)
#debug concat(str(dimension_size(A, 1), 0, 0), str(A[1], 0, 0), "\n")
