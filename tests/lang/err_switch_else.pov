// A #switch needs a case before its #else.
#version 3.7;
#switch (1) #else #debug "x\n" #end
sphere { 0, 1 }
