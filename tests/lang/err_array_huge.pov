// An array that no memory can hold.
#version 3.7;
#declare A = array[1e9];
