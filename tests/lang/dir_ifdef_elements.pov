// #ifdef of an element tells whether it was assigned.
#version 3.7;
#declare A = array[2][2];
#declare A[1][0] = 5;
#ifdef (A) #debug "array\n" #end
#ifdef (A[1][0]) #debug "assigned\n" #end
#ifndef (A[0][0]) #debug "not assigned\n" #end
#debug concat(str(defined(A[1][0]), 0, 0), str(defined(A[0][1]), 0, 0), "\n")
