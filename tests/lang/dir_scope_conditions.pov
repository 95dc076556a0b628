// Conditions and loops open no scope.
#version 3.7;
#if (1) #local A = 1; #end
#while (!defined(B)) #local B = 2; #end
#for (I, 1, 1) #local C = 3; #end
#debug concat(str(A, 0, 0), str(B, 0, 0), str(C, 0, 0), str(I, 0, 0), "\n")
