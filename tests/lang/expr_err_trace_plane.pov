// The normal of trace cannot go to a vector of two.
#version 3.7;
#declare S = sphere { 0, 1 }
#declare N = <1, 2>;
#declare A = trace(S, -5*z, z, N);
