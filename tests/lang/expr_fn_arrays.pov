// dimensions and dimension_size.
#version 3.7;
#declare A = array[2][3][4];
#debug concat(str(dimensions(A), 0, 0), str(dimension_size(A, 1), 0, 0), str(dimension_size(A,
	2.9), 0, 0),
	str(dimension_size(A, 3), 0, 0), str(dimension_size(A, 4), 0, 0), str(dimension_size(A, 0),
		0, 0), "\n")
