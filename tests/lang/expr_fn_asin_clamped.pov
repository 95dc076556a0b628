// asin and acos of values beyond 1 are those of 1.
#version 3.7;
#debug concat(str(asin(2), 0, 9), " ", str(asin(-2), 0, 9), " ", str(acos(2), 0, 9), " ",
	str(acos(-1.5), 0, 9), "\n")
