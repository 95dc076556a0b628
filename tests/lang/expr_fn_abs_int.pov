// abs, int (to zero), ceil, floor.
#version 3.7;
#macro M(X) #debug concat(vstr(4, <abs(X), int(X), ceil(X), floor(X)>, " ", 0, 2), "\n") #end
M(2.5) M(-2.5) M(3) M(-0.5)
