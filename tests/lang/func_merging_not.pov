// Where constants are merged as arithmetic has it.
#version 3.7;
#declare A = function(x) { x - sqrt(4) - 4 }
#declare B = function(x) { x - (2*3) + 1 }
#declare C = function(x) { x - 2 - 4 }
#declare D = function(x) { x/2*5 }
#declare E = function(x) { 2 - 3*x + 4 }
#declare K = 3;
#declare F = function(x) { x - K - K + K*K*x/K }
#debug concat(str(A(1), 0, 6), " ", str(B(1), 0, 6), " ", str(C(1), 0, 6), " ", str(D(1), 0, 6),
	" ")
#debug concat(str(E(1), 0, 6), " ", str(F(2), 0, 6), "\n")
