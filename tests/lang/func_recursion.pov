// A function that calls itself. POV-Ray says so too but goes on.
// lambert only
#version 3.7;
#declare F = function(x) { F(x - 1) }
