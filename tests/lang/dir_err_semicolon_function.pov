// Behind the name of a function, which could be called, a semicolon is needed.
#version 3.7;
#declare F = function(x) { x }
#declare G = F
sphere { 0, 1 }
