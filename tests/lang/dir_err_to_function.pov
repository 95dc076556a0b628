// What is declared cannot become a function.
#version 3.7;
#declare F = 5;
#declare F = function(x) { x }
