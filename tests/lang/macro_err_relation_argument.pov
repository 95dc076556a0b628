// Arguments are read at sum level: a relation needs parentheses.
#version 3.7;
#macro M(A) #end
M(1 > 2)
