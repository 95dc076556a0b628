// Arrays of two dimensions, initialised and assigned.
#version 3.7;
#declare A = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 } }
#declare A[1][2] = 60;
#debug concat(str(A[0][1], 0, 0), " ", str(A[1][2], 0, 0), "\n")
#debug concat(str(dimensions(A), 0, 0), " ", str(dimension_size(A, 2), 0, 0), "\n")
