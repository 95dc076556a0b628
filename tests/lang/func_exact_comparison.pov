// Comparisons in functions have no tolerance, others have.
#version 3.7;
#declare F = function(a, b) { (a = b) + 10*(a <= b) + 100*(a >= b) + 1000*(a != b) }
#declare E = 1 + 1e-12;
#debug concat(str(F(1, E), 0, 0), " ", str((1 = E), 0, 0), " ", str(F(1, 1), 0, 0), "\n")
