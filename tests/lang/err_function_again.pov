#version 3.7;
#declare F = function(x) { x }
#declare F = 3;
