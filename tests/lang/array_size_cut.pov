// The size of a dimension is cut to a whole number.
#version 3.7;
#declare A = array[2.9999];
#declare B = array[2.99999999999];
#debug concat(str(dimension_size(A, 1), 0, 0), str(dimension_size(B, 1), 0, 0), "\n")
