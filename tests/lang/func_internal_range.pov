// The built-in functions have numbers up to 78.
#version 3.7;
#declare F = function { internal(79) }
