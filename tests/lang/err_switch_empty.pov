// A #switch needs a case.
#version 3.7;
#switch (1) #debug "x\n" #end
sphere { 0, 1 }
