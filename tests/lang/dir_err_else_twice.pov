// Behind a taken #else a second #else is an error.
#version 3.7;
#if (0) #else #debug "else\n" #else #end
