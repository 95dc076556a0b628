// A parameter by reference lives in the innermost table: #local writes to the caller's variable,
// too.
#version 3.7;
#macro M(P) #local P = P + 1; #end
#declare A = 1;
M(A)
#debug concat(str(A, 0, 0), "\n")
