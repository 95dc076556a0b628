// There is no ?: in functions.
#version 3.7;
#declare F = function(x) { x > 0 ? 1 : 2 }
