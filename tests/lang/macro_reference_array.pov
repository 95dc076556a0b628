// An array is passed by reference: its elements can be set.
#version 3.7;
#macro Fill(A) #for (I, 0, dimension_size(A, 1) - 1) #declare A[I] = I*I; #end #end
#declare B = array[4]; Fill(B)
#debug concat(str(B[0], 0, 0), str(B[1], 0, 0), str(B[2], 0, 0), str(B[3], 0, 0), "\n")
