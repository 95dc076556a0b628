// Each place of a long chain of calls is shown once.
#version 3.7;
#macro A(N) B(N) #end
#macro B(N) A(N) #end
A(1)
