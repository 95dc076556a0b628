// rand has no meaning in a function.
#version 3.7;
#declare R = seed(1);
#declare F = function(x) { rand(R) }
