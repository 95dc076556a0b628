// One sign may stand before an operand, also behind an operator.
#version 3.7;
#declare F = function(x) { -x*2 - -x + +3 }
#declare G = function(x) { 2--x }
#debug concat(str(F(5), 0, 6), " ", str(G(4), 0, 6), "\n")
