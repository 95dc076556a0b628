// x and u are one variable, y and v too: the last in the list counts; without it they are 0.
#version 3.7;
#declare F = function(y) { x }
#declare G = function(u, x) { u*10 + x }
#declare H = function(v, z) { y*10 + z }
#declare K = function { x + 10*y + 100*z }
#declare L = function(a, b) { a/b }
#debug concat(str(F(5), 0, 1), " ", str(G(1, 2), 0, 1), " ", str(H(1, 2), 0, 1), " ",
	str(K(1, 2, 3), 0, 1), " ")
#debug concat(str(L(1, 4), 0, 2), "\n")
