// The arguments of max are read at sum level: a relation needs parentheses.
#version 3.7;
#declare A = max(1 > 2, 3);
