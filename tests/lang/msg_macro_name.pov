// A parameter with the name of its macro, which may be a call.
#version 3.7;
#macro M(A, M) A #end
