// A pigment of a function, and a function of that pigment.
#version 3.7;
#declare F = function { x*x + y }
#declare P = function { pigment { function { F(x, y, z) } color_map { [0 rgb 0]
	[1 rgb <1, 2, 4>] } } }
#debug concat(vstr(3, P(0.5, 0, 0), " ", 0, 6), " ", vstr(3, P(0.5, 0.9, 0), " ", 0, 6), "\n")
