// A shorter vector that meets a longer one is padded with zeros.
#version 3.7;
#declare C = rgb 1;
#debug concat(vstr(4, <1, 2> + <1, 2, 3, 4>, ",", 0, 0), " ", vstr(5, C + u, ",", 0, 0), " ",
	vstr(5, C + 2*v, ",", 0, 0),
	" ", vstr(4, t + <1, 2, 3>, ",", 0, 0), " ", vstr(5, C*x, ",", 0, 0), "\n")
