// Constants are merged from left to right, not always as arithmetic would have it.
#version 3.7;
#declare G = function(x) { x }
#declare A = function(x) { x - 2*3 + 1 }
#declare B = function(x) { x - 2*3 - 1 }
#declare C = function(x) { x - 2*3 - 2*3 }
#declare D = function(x) { x - -2 + 1 }
#declare E = function(x) { G(6)/3*2 }
#declare F = function(x) { sin(1)/2*4 }
#declare H = function(x) { x < 20 < 3 }
#debug concat(str(A(0), 0, 6), " ", str(B(0), 0, 6), " ", str(C(0), 0, 6), " ", str(D(0), 0, 6),
	" ")
#debug concat(str(E(0), 0, 6), " ", str(F(0), 0, 6), " ", str(H(1), 0, 0), str(H(-1), 0, 0),
	str(H(30), 0, 0), "\n")
