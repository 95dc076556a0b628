// In relations a shorter left operand is padded: with itself if a float, else with zeros.
#version 3.7;
#debug concat(vstr(4, (<0, 5> < <1, 1, 1, -1>), ",", 0, 0), " ", vstr(3, (<1, 2> = <1, 2, 0>), ",",
	0, 0), "\n")
