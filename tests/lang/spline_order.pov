// Entries are sorted by their keys.
#version 3.7;
#declare S = spline { 3, <3, 0, 0> 1, <1, 0, 0> 2, <20, 0, 0> 0, <0, 0, 0> }
#for (P, 0, 3, 0.5) #debug concat(str(S(P).x, 0, 3), " ") #end
#debug "\n"
