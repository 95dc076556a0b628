// max and min of one argument or more.
#version 3.7;
#debug concat(str(max(3), 0, 0), str(max(1, 5, 2), 0, 0), str(min(4, 2, 3), 0, 0), str(min(7), 0,
	0), "\n")
#declare N = mod(1, 0);
#debug concat(str(max(1, N), 0, 0), str(min(1, N), 0, 0), "\n")
