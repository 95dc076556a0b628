// A function without a body.
#version 3.7;
#declare F = function(x) { }
