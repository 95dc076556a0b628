// c ? a : b; the branches are full expressions.
#version 3.7;
#declare A = 3;
#debug concat(str((A > 2 ? 10 : 20), 0, 0), " ", str((A < 2 ? 10 : A < 4 ? 30 : 40), 0, 0), " ",
	str((1 ? A > 1 : 7), 0, 0), " ", str((1e-11 ? 1 : 2), 0, 0), "\n")
