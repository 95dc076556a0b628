// The variable of #for cannot be an element of an array.
#version 3.7;
#declare A = array[2];
#for (A[0], 1, 2) #end
