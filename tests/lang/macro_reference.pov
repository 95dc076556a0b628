// A single identifier is passed by reference: #declare of the parameter writes to it.
#version 3.7;
#macro Set(P, V) #declare P = V; #end
#declare A = 1; Set(A, 2)
#declare B = "s"; Set(B, <1, 2, 3>)
#declare C = array[2] { 1, 2 } Set(C[1], 5)
#debug concat(str(A, 0, 0), str(B.y, 0, 0), str(C[1], 0, 0), "\n")
