// Arithmetic is in double precision.
#version 3.7;
#declare A = 1;
#declare I = 0;
#while (I < 52) #declare A = A/2; #declare I = I + 1; #end
#debug concat(str(1 + A - 1, 0, 20), " ", str(1/3, 0, 17), "\n")
