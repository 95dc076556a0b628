// Functions call others, of any number of arguments, with commas or without.
#version 3.7;
#declare F = function(a, b, c) { a + 2*b + 3*c }
#declare G = function(x) { F(x, x*x, F(1, x, 2)) }
#debug concat(str(G(3), 0, 6), " ", str(F(1 2 3), 0, 6), " ", str(2*F(1, 2, 3).x, 0, 6), "\n")
