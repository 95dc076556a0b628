// vdot, vlength, vcross, vnormalize.
#version 3.7;
#debug concat(str(vdot(<1, 2, 3>, <4, 5, 6>), 0, 0), " ", str(vlength(<2, 3, 6>), 0, 0), " ",
	vstr(3, vcross(<1, 2, 3>, <4, 5, 6>), ",", 0, 0), " ", vstr(3, vnormalize(<3, 0, 4>), ",",
		0, 4), "\n")
