// A macro may give back a string.
#version 3.7;
#macro Twice(S) concat(S, S) #end
#debug concat(Twice("ab"), Twice(Twice("c")), "\n")
