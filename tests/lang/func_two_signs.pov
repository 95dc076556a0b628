// Two signs are an error.
#version 3.7;
#declare F = function(x) { - -x }
