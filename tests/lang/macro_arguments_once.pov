// An argument is evaluated once, from left to right.
#version 3.7;
#declare R = seed(1);
#macro M(A, B) #debug concat(str(A, 0, 6), " ", str(A, 0, 6), " ", str(B, 0, 6), "\n") #end
M(rand(R), rand(R))
