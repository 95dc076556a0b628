// At the top level of the scene #local is #declare.
#version 3.7;
#local A = 1;
#macro M() #declare A = A + 1; #end
M()
#debug concat(str(A, 0, 0), "\n")
