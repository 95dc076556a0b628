// An undeclared word in an expression.
#version 3.7;
#declare A = 1 + Nothing;
