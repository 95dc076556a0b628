// vstr: the number of components is kept within 2 to 5, missing ones are 0.
#version 3.7;
#debug concat(vstr(3, <1, 2, 3>, ", ", 0, 1), "|", vstr(1, <1, 2, 3>, ", ", 0, 1), "\n")
#debug concat(vstr(9, <1, 2>, ";", 0, 0), "\n")
#debug concat(vstr(3, 5, ",", 0, 0), "|", vstr(2, x + y, "/", 5, 2), "|",
	vstr(3.9, <1, 2, 3, 4>, "", -4, 1), "\n")
