// A reference to a reference is the original variable.
#version 3.7;
#macro Inner(P) #declare P = P + 1; #end
#macro Outer(Q) Inner(Q) Inner(Q) #end
#declare A = 1; Outer(A)
#declare B = array[1] { 5 } Outer(B[0])
#debug concat(str(A, 0, 0), str(B[0], 0, 0), "\n")
