// A macro without its #end.
#version 3.7;
#macro M(A)
	#if (A) #end
