// seed() returns the number of the stream in order of creation; any float may name it.
#version 3.7;
#declare A = seed(7);
#declare B = seed(7);
#debug concat(str(A, 0, 0), " ", str(B, 0, 0), "\n")
#debug concat(str(rand(0), 0, 9), " ", str(rand(A), 0, 9), " ", str(rand(1.9), 0, 9), "\n")
