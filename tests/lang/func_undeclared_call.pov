// A function that is not declared.
#version 3.7;
#declare F = function(x) { f_spere(x, y, z, 1) }
