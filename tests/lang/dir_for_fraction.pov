// #for (I, 0, 1, 0.1) makes 11 passes: the end has a tolerance.
#version 3.7;
#declare N = 0; #for (I, 0, 1, 0.1) #declare N = N + 1; #end
#debug concat(str(N, 0, 0), " ", str(I, 0, 15), "\n")
