// A function of a pigment gives five components; in a body one is selected.
#version 3.7;
#declare P = function { pigment { gradient x color_map { [0 rgbft <1, 0, 0, 0.25, 0.5>]
	[1 rgb z] } } }
#declare C = P(0.25, 0, 0);
#declare F = function { P(x, y, z).red + 10*P(x, y, z).blue + 100*P(x, y, z).filter }
#declare G = function { P(x, y, z).transmit + 10*P(x, y, z).gray + 100*P(x, y, z).green }
#declare H = function { P(x, y, z).hf + P(x, y, z).x + P(x, y, z).v + P(x, y, z).t }
#debug concat(vstr(5, C, " ", 0, 6), " ", str(F(0.25, 0, 0), 0, 6), " ",
	str(G(0.25, 0, 0), 0, 6), " ")
#debug concat(str(H(0.25, 0, 0), 0, 6), " ", str(P(0.25, 0, 0).red, 0, 6), "\n")
