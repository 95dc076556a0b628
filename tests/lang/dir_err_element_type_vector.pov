// A float is not promoted to the type of an array's elements.
#version 3.7;
#declare A = array[2] { x, y }
#declare A[0] = 1;
