// A macro changes an element that it is given.
#version 3.7;
#macro Double(A) #declare A = A*2; #end
#macro Fill(B) #for (I, 0, dimension_size(B, 1) - 1) #declare B[I] = I*I; #end #end
#declare V = array[3] { 1, 2, 3 }
Double(V[1])
#debug concat(str(V[1], 0, 0), " ")
Fill(V)
#debug concat(str(V[0], 0, 0), str(V[1], 0, 0), str(V[2], 0, 0), "\n")
