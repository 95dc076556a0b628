// The constants.
#version 3.7;
#debug concat(str(true + yes + on, 0, 0), str(false + no + off, 0, 0), " ", str(pi, 0, 15), " ",
	str(version, 0, 2), " ",
	str(clock, 0, 0), str(clock_on, 0, 0), " ", str((now > 8000), 0, 0), "\n")
