// A call where a parameter should be.
#version 3.7;
#macro M(A) A #end
#macro N(M(1)) 1 #end
