// Bitwise functions of integers of 32 bits, of two arguments or more.
#version 3.7;
#debug concat(str(bitwise_and(12, 10), 0, 0), " ", str(bitwise_or(12, 10), 0, 0), " ",
	str(bitwise_xor(12, 10), 0, 0),
	" ", str(bitwise_and(-1, 255, 60), 0, 0), " ", str(bitwise_or(1, 2, 4.9), 0, 0), " ",
		str(bitwise_xor(-1, 0), 0, 0), "\n")
