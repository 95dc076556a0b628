// A comma behind the range does not call for a step; a #switch may match nothing.
#version 3.7;
#for (I, 0, 3,) #debug concat(str(I, 0, 0), "\n") #end
#for (I, 3, 0,) #debug concat(str(I, 0, 0), "\n") #end
#switch (1) #case (2) #debug "two\n" #end
#switch (1) #debug "before\n" #if (1) #debug "in\n" #end #range (0, 2) #debug "range\n" #end
#switch (1) #case (2) #debug "two\n" #else #debug "else\n" #end
sphere { 0, 1 }
