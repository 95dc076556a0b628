// Directives within the body of a function are executed while it is read.
#version 3.7;
#declare F = function(x) { x #for (I, 1, 3) + I #end };
#declare G = function(x) { #if (1) x*2 #else x*3 #end };
#debug concat(str(F(1), 0, 0), str(G(4), 0, 0), "\n")
