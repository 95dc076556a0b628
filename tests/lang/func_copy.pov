// Functions are values: copies, macro arguments, array elements.
#version 3.7;
#declare F = function(x) { x*x }
#declare G = F;
#declare A = array[2] { function(x) { x + 1 }, function(x) { x + 2 } }
#declare H = function(x) { G(x) + A[1](x) }
#macro Twice(Fn, X) Fn(Fn(X)) #end
#debug concat(str(G(3), 0, 1), " ", str(A[0](5), 0, 1), " ", str(H(2), 0, 1), " ",
	str(Twice(F, 3), 0, 1), "\n")
