// Powers up to 8 are products, others what the C library says.
#version 3.7;
#declare F = function(x) { pow(x, 2) + pow(x, 3) + pow(x, 5) + pow(x, 7) }
#declare G = function(x) { pow(x, 4) + pow(x, 6) + pow(x, 8) + pow(x, 9) + pow(x, 0.5) + pow(x, -2) }
#debug concat(str(F(1.1), 0, 15), " ", str(G(1.1), 0, 15), "\n")
