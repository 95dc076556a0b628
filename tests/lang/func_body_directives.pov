// Directives and macros work in a body.
#version 3.7;
#macro Square() x*x #end
#declare F = function(x) { Square() #for (I, 1, 3) + I*x #end #if (0) + 1000 #end }
#debug concat(str(F(2), 0, 6), "\n")
