#version 3.7;
#macro M(A)
#if (1)
#end
