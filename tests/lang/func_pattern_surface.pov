// Patterns that need a surface, or have more values than one, make no function.
#version 3.7;
#declare A = function { pattern { slope y } }
