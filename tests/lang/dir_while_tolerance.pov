// #while begins beyond 1e-10 and ends below.
#version 3.7;
#declare A = 1; #declare N = 0;
#while (A) #declare A = A/10; #declare N = N + 1; #end
#while (1e-11) #declare N = 99; #break #end
#debug concat(str(N, 0, 0), "\n")
