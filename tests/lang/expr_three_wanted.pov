// Where three components are wanted a float is copied and a 2-vector gets z = 0.
#version 3.7;
#debug concat(str(vlength(2), 0, 6), " ", str(vlength(<3, 4>), 0, 6), " ", vstr(3, vcross(u, v),
	",", 0, 0), " ",
	vstr(3, vrotate(1, 0), ",", 0, 0), "\n")
