// All users of a number share one state, and a copy of the number is the same stream.
#version 3.7;
#declare A = seed(33);
#declare B = A;
#macro Next(S) rand(S) #end
#debug concat(str(rand(A), 0, 9), " ", str(rand(B), 0, 9), " ", str(Next(A), 0, 9), "\n")
#debug concat(str(rand(seed(33)), 0, 9), "\n")
