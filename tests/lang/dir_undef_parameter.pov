// #undef of a parameter by reference removes the parameter only.
#version 3.7;
#declare A = 1;
#macro M(P) #undef P #debug concat(str(defined(P), 0, 0), "\n") #end
M(A)
#debug concat(str(A, 0, 0), "\n")
