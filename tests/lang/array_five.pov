// Five dimensions, the last subscript fastest in the initialiser.
#version 3.7;
#declare A = array[1][2][1][2][2] { { { { { 1, 2 }, { 3, 4 } } }, { { { 5, 6 }, { 7, 8 } } } } }
#debug concat(str(A[0][1][0][1][0], 0, 0), str(A[0][0][0][1][1], 0, 0), str(dimensions(A), 0, 0), "\n")
