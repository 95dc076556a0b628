// #local of an element of an outer array: reached if the array is empty yet, lost if not.
#version 3.7;
#declare A = array[2];
#macro M(V) #local A[0] = V; #end
M(1) M(2)
#debug concat(str(A[0], 0, 0), "\n")
#macro N() #local B = array[1] { 5 } #local B[0] = 6; #debug concat(str(B[0], 0, 0), "\n") #end
N()
