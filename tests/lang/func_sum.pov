// sum and prod: the upper end need not be whole, an empty range is 0 or 1, they may be nested.
#version 3.7;
#declare F = function(n) { sum(i, 1, n, i*i) }
#declare G = function(n) { prod(i, 1, n, i) }
#declare H = function(n) { sum(i, 1, n, sum(j, i, n, i*j)) }
#debug concat(str(F(4), 0, 1), " ", str(F(2.5), 0, 1), " ", str(F(0), 0, 1), " ",
	str(G(5), 0, 1), " ")
#debug concat(str(G(0), 0, 1), " ", str(H(3), 0, 1), "\n")
