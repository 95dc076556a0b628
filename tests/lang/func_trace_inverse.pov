// The normal of an inverse object is turned; trace needs no normal.
#version 3.7;
#declare O = sphere { 0, 2 inverse }
#declare N = <0, 0, 0>;
#declare P = trace(O, <-5, 0, 0>, x, N);
#debug concat(vstr(3, P, " ", 0, 6), "|", vstr(3, N, " ", 0, 6), "|", vstr(3, trace(O, 0, y),
	" ", 0, 6), "\n")
