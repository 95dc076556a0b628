// An undeclared word cannot be an argument.
#version 3.7;
#macro M(A) #declare A = 5; #end
M(Nothing)
