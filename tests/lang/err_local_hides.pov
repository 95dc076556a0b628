#version 3.7;
#macro M(A) #local G = G + 1; #end
#declare G = 1;
M(1)
