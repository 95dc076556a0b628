// The value of #declare is read at sum level: a relation needs parentheses.
#version 3.7;
#declare A = 3 > 2;
