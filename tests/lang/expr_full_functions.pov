// Functions of one float read a full expression.
#version 3.7;
#debug concat(str(abs(1 > 2), 0, 0), str(int(1 < 2), 0, 0), str(sin(1 ? 0 : 1), 0, 0), chr(1 ? 65 :
	66), "\n")
