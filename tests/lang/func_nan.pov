// What is no number: > >= and != say 1, = < and <= say 0; min, max and select pass it on by place.
#version 3.7;
#declare N = function(x) { sqrt(x) }
#declare F = function(x, y) { (N(x) = y) + 10*(N(x) < y) + 100*(N(x) <= y) }
#declare G = function(x, y) { (N(x) > y) + 10*(N(x) >= y) + 100*(N(x) != y) }
#declare A = function(x, y) { min(y, N(x)) = y }
#declare B = function(x, y) { min(N(x), y) }
#declare C = function(x, y) { max(y, N(x)) }
#declare D = function(x, y) { max(N(x), y) = y }
#declare S = function(x) { select(N(x), 1, 2, 3) + 10*select(N(x), 1, 2) }
#debug concat(str(F(-1, 0), 0, 0), " ", str(G(-1, 0), 0, 0), " ", str(A(-1, 7), 0, 0),
	str(B(-1, 7), 0, 0))
#debug concat(str(C(-1, 7), 0, 0), str(D(-1, 7), 0, 0), " ", str(S(-1), 0, 0), "\n")
