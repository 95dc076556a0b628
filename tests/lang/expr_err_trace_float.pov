// The normal of trace cannot go to a float.
#version 3.7;
#declare S = sphere { 0, 1 }
#declare N = 5;
#declare A = trace(S, -5*z, z, N);
