// A component selected first of a 3-vector keeps the others of the vector it was taken from.
#version 3.7;
#declare V = <1, 2, 3>;
#debug concat(str(vlength(V.y), 0, 6), " ", str(vlength((V.y)), 0, 6), " ", str(vlength(2*V.y), 0,
	6), " ",
	str(vlength(V.y*2), 0, 6), " ", str(vlength(-V.z), 0, 6), " ", str(vlength(+0 + V.y), 0,
		6), "\n")
