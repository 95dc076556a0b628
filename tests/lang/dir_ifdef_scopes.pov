// #ifdef looks in all scopes, and sees macros, functions and files.
#version 3.7;
#macro M(P) #local L = 1; #debug concat(str(defined(P), 0, 0), str(defined(L), 0, 0),
	str(defined(M), 0, 0), "\n") #end
M(1)
#declare F = function(x) { x }
#debug concat(str(defined(F), 0, 0), str(defined(P), 0, 0), str(defined(L), 0, 0), "\n")
