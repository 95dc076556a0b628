// Behind a taken #if a second #else is skipped.
#version 3.7;
#if (1) #debug "taken\n" #else #debug "a\n" #else #debug "b\n" #end
