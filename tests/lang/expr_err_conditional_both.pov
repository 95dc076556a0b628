// Both branches of ?: are evaluated: an undeclared word in either is an error.
#version 3.7;
#declare A = (1 ? 5 : Nothing);
