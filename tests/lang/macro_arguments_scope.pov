// Arguments are evaluated in the scope of the caller, before the parameters exist.
#version 3.7;
#declare A = 1; #declare B = 2;
#macro M(A, B) #debug concat(str(A, 0, 0), str(B, 0, 0), "\n") #end
M(B + 0, A + 0)
M(B, A)
