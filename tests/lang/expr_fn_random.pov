// Streams of random numbers; seeds are cut to integers of 32 bits.
#version 3.7;
#declare A = seed(1); #declare B = seed(-1.7); #declare C = seed(1);
#debug concat(str(A, 0, 0), str(B, 0, 0), str(C, 0, 0), "\n")
#debug concat(vstr(3, <rand(A), rand(A), rand(A)>, " ", 0, 12), "\n")
#debug concat(vstr(3, <rand(B), rand(B), rand(C)>, " ", 0, 12), " ", str(rand(seed(5)), 0, 12),
	"\n")
