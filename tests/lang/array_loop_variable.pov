// The variable of #for cannot be an element.
#version 3.7;
#declare A = array[2];
#for (A[1], 1, 3) #debug str(A[1], 0, 0) #end
