// A subscript is cut to a whole number, but 1e-10 below one counts as that.
#version 3.7;
#declare A = array[3] { 10, 20, 30 }
#debug concat(str(A[1.9], 0, 0), " ", str(A[0.99999999999], 0, 0), " ", str(A[-0.00000000001], 0, 0), "\n")
