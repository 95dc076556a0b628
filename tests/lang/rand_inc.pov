// The distributions of rand.inc stand on the same streams.
#version 3.7;
#include "rand.inc"
#declare R = seed(11);
#debug concat(str(RRand(2, 5, R), 0, 9), " ", str(SRand(R), 0, 9), "\n")
#debug concat(vstr(3, VRand(R), " ", 0, 8), " ", vstr(3, VRand_On_Sphere(R), " ", 0, 8), "\n")
#debug concat(str(Rand_Gauss(0, 1, R), 0, 8), " ", str(Rand_Normal(3, 2, R), 0, 8), "\n")
#debug concat(str(Rand_Bernoulli(0.5, R), 0, 0), " ", str(Rand_Poisson(3, R), 0, 0), "\n")
#debug concat(vstr(3, VRand_In_Box(-1, 2, R), " ", 0, 8), "\n")
