// A seed is cut to a whole number and a negative one wraps.
#version 3.7;
#declare R = seed(-1.7);
#debug concat(str(rand(R), 0, 12), " ", str(rand(R), 0, 12), "\n")
#declare Q = seed(-1);
#debug concat(str(rand(Q), 0, 12), "\n")
#declare P = seed(4294967295);
#debug concat(str(P, 0, 0), "\n")
