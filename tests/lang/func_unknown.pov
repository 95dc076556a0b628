// A word that is no parameter.
#version 3.7;
#declare F = function(x) { x + Radius }
