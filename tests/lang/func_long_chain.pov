// A chain of operators longer than the compiler of functions follows.
#version 3.7;
#declare N = 300;
#declare F = function(x) { x #while (N > 0) + x #declare N = N - 1; #end };
#declare A = F(1);
