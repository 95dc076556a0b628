// t is no parameter.
#version 3.7;
#declare F = function(t) { t*2 }
