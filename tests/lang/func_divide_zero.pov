// Division by a constant 0.
#version 3.7;
#declare F = function(x) { x/0 }
