// Arrays in an array may have different sizes and are reached by more subscripts.
#version 3.7;
#declare A = array[3]
#declare A[0] = array[1] { 5 }
#declare A[1] = array[2][2] { { 1, 2 }, { 3, 4 } }
#declare A[2] = A[0]
#debug concat(str(A[1][1][0], 0, 0), str(A[2][0], 0, 0), str(dimensions(A[1]), 0, 0), "\n")
#declare A[1][0][1] = 8;
#debug concat(str(A[1][0][1], 0, 0), "\n")
