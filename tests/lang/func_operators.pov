// Operators of a function: products before sums before comparisons before & before |.
#version 3.7;
#declare F = function(x, y) { 1 + 2*x - y/4 }
#declare G = function(x) { 1 | 0 & x }
#declare H = function(x) { x < 2 & x > 0 | x = 5 }
#debug concat(str(F(3, 2), 0, 6), " ", str(G(0), 0, 0), " ", str((1 | 0 & 0), 0, 0), " ")
#debug concat(str(H(1), 0, 0), str(H(2), 0, 0), str(H(5), 0, 0), "\n")
