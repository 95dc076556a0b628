// Vectors are no operands of functions.
#version 3.7;
#declare V = <1, 2, 3>;
#declare F = function(x) { x*V.x }
