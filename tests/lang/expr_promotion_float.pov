// A float that meets a vector is copied to every component, of colours to all five.
#version 3.7;
#declare C = rgbft <0.5, 0.25, 1, 0.125, 0>;
#debug concat(vstr(2, 2*<1, 2>, ",", 0, 0), " ", vstr(3, <1, 2, 3> - 1, ",", 0, 0), " ", vstr(5, 1
	- C, ",", 0, 3), " ",
	vstr(4, 1/<1, 2, 4, 8>, ",", 0, 3), "\n")
