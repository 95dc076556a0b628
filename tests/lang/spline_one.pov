// One entry is the value everywhere, whatever the type.
#version 3.7;
#declare S = spline { natural_spline 5, <1, 2, 3> }
#debug concat(vstr(3, S(0), " ", 0, 2), " ", vstr(3, S(9), " ", 0, 2), " ",
	vstr(3, S(5, cubic_spline), " ", 0, 2), "\n")
