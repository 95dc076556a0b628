// Division by 0 gives +infinity, whatever the numerator.
#version 3.7;
#debug concat(str(1/0, 0, 0), " ", str(-1/0, 0, 0), " ", str(0/0, 0, 0), " ", vstr(3, <1, 2, 3>/<1,
	0, 2>, ",", 0, 1), "\n")
