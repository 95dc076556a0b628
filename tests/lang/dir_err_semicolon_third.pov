// A third semicolon is an error.
#version 3.7;
#declare A = 1;;;
