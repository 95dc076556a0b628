// Below version 3.5 an assignment is complete before the next directive runs.
#version 3.0;
#declare A = 5 #declare B = A #declare A = 6
#debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
