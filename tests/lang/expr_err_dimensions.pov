// dimensions wants an array.
#version 3.7;
#declare A = 5;
#declare B = dimensions(A);
