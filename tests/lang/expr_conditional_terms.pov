// The result of ?: has the terms of the branch chosen.
#version 3.7;
#declare A = (0 ? <1, 2, 3> : 5);
#declare B = (1 ? <1, 2, 3> : 5);
#debug concat(str(A, 0, 0), " ", str(B.z, 0, 0), "\n")
