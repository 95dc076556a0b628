// A call with another number of arguments than the function has parameters.
#version 3.7;
#declare F = function(a, b) { a + b }
#declare G = function(x) { F(x) }
