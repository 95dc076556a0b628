// Infinity and what is no number.
#version 3.7;
#declare I = 1/0;
#declare N = pow(-1, 0.5);
#debug concat(str(I, 0, 2), " ", str(-I, 0, 2), " ", strlwr(str(N, 0, 2)), " ", str(I, 8, 2), "\n")
