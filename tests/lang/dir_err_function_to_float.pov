// A function cannot be replaced.
#version 3.7;
#declare F = function(x) { x }
#local F = function(x) { 2*x }
