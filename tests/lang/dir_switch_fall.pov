// Execution falls through parts, #else among them, until #break or #end.
#version 3.7;
#macro M(V) #switch (V) #case (1) #debug "1" #case (2) #debug "2" #range (3, 4) #debug "3" #break
	#case (5) #debug "5"
	#else #debug "e" #end #debug "\n" #end
M(1) M(2) M(4) M(5) M(6)
