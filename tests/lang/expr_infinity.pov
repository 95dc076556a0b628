// Infinities are values like others.
#version 3.7;
#declare I = 1/0;
#debug concat(str((I > 1e300), 0, 0), str((I = I), 0, 0), str((-I < 0), 0, 0), " ", str(1/I, 0, 0),
	" ", str(-I, 0, 0), "\n")
