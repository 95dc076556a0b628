// A dimension of no elements.
#version 3.7;
#declare A = array[0];
