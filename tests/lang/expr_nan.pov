// NaN equals everything and is not less than anything.
#version 3.7;
#declare N = mod(1, 0);
#debug concat(str((N = N), 0, 0), str((N != N), 0, 0), str((N < 1), 0, 0), str((N > 1), 0, 0),
	str((N = 3), 0, 0),
	str(!N, 0, 0), "\n")
