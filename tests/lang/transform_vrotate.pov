// vrotate: about x, then y, then z, in degrees.
#version 3.7;
#debug concat(vstr(3, vrotate(x, 90*y), " ", 0, 6), "|", vstr(3, vrotate(y, 90*x), " ", 0, 6), "\n")
#debug concat(vstr(3, vrotate(<1, 2, 3>, <10, 20, 30>), " ", 0, 9), "|", vstr(3, vrotate(x, 45),
	" ", 0, 9), "\n")
