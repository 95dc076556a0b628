// sqr is no function: pow(x, 2) is.
#version 3.7;
#declare F = function(x) { sqr(x) }
