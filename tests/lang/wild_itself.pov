// A scene that includes itself once.
#ifndef (WILD) #declare WILD = 1; #include "wild_itself.pov" #debug "outer\n" #else #debug "inner\n" #end
