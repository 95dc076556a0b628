// Relations of vectors give vectors.
#version 3.7;
#debug concat(vstr(3, (<1, 2, 3> < <2, 2, 2>), ",", 0, 0), " ", vstr(3, (<1, 2, 3> = <1, 2, 4>),
	",", 0, 0),
	" ", vstr(3, (<1, 2, 3> >= <2, 2, 2>), ",", 0, 0), " ", vstr(3, (2 < <1, 2, 3>), ",", 0,
		0), "\n")
