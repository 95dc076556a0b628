// The normal of trace goes to a 3-vector that is declared.
#version 3.7;
#declare S = sphere { 0, 1 }
#declare A = trace(S, -5*z, z, N);
