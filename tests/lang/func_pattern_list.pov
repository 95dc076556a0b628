// A function of a pattern has no list of parameters.
#version 3.7;
#declare F = function(x, y) { pattern { gradient x } }
