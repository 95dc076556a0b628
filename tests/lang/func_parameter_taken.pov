// A parameter's name must be free.
#version 3.7;
#declare Radius = 5;
#declare F = function(Radius) { Radius*2 }
