// The unit vectors: x y z of three terms, u v of two, t of four.
#version 3.7;
#debug concat(vstr(3, x, ",", 0, 0), " ", vstr(3, y, ",", 0, 0), " ", vstr(3, z, ",", 0, 0), " ",
	vstr(2, u, ",", 0, 0),
	" ", vstr(2, v, ",", 0, 0), " ", vstr(4, +t, ",", 0, 0), "\n")
