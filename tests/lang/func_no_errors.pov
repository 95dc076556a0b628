// Functions compute on where an expression would stop: infinities, 0 and 1.
#version 3.7;
#declare D = function(x, y) { x/y }
#declare L = function(x) { ln(x) }
#declare P = function(x, y) { pow(x, y) }
#declare A = function(x, y) { atan2(x, y) }
#debug concat(str(D(1, 0), 0, 0), " ", str(D(-1, 0), 0, 0), " ", str(L(0), 0, 0), " ",
	str(P(0, 0), 0, 0), " ")
#debug concat(str(A(0, 0), 0, 0), "\n")
