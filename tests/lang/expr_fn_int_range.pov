// int beyond 32 bits, and of what is no number, gives -2147483648.
#version 3.7;
#debug concat(str(int(2147483647), 0, 0), " ", str(int(2147483648), 0, 0), " ",
	str(int(-3000000000), 0, 0), " ",
	str(int(1e300), 0, 0), " ", str(int(sqrt(2)*1e9), 0, 0), "\n")
