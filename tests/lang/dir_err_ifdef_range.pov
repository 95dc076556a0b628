// #ifdef of an element that the array does not have is an error.
#version 3.7;
#declare A = array[2] { 1, 2 }
#ifdef (A[2]) #end
