// #if takes values beyond 1e-10 for true.
#version 3.7;
#if (1e-11) #debug "wrong\n" #else #debug "0\n" #end
#if (-1e-9) #debug "1\n" #end
#if (1/0) #debug "infinite\n" #end
