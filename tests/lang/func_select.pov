// select with three and four values computes only what it chooses.
#version 3.7;
#declare F = function(x) { select(x, -10, 10) }
#declare G = function(x) { select(x, -10, 0.5, 10) }
#declare H = function(x) { select(x, ln(x), sqrt(x)) }
#debug concat(str(F(-1), 0, 1), str(F(0), 0, 1), str(F(1), 0, 1), " ", str(G(-1), 0, 1),
	str(G(0), 0, 1), " ")
#debug concat(str(G(1), 0, 1), " ", str(H(4), 0, 1), "\n")
