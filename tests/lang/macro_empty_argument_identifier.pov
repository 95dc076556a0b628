// A macro may declare what the caller then uses.
#version 3.7;
#macro Make(V) #declare Made = V; #end
Make(5)
#debug concat(str(Made, 0, 0), "\n")
