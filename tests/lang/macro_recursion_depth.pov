// 97 nested calls are allowed.
#version 3.7;
#macro M(N) #if (N > 1) M(N - 1) #else #debug "bottom\n" #end #end
M(97)
