// Below version 3.1 no semicolon is needed, below 3.5 it is only expected.
#version 3.0;
#declare A = 5
#declare B = A + 1
#version 3.1;
#declare C = B + 1
#debug concat(str(A, 0, 0), str(B, 0, 0), str(C, 0, 0), "\n")
