// .gray weighs red, green and blue.
#version 3.7;
#declare C = rgb <1, 0, 0>;
#debug concat(str(C.gray, 0, 6), " ", str(<0, 1, 0>.gray, 0, 6), " ", str(<0, 0, 1, 7>.gray, 0, 6),
	"\n")
