// Parts behind #else are tried when nothing matched before, and fallen into.
#version 3.7;
#macro M(V) #switch (V) #case (1) #debug "1" #break #else #debug "e" #case (2) #debug "2" #end
	#debug "\n" #end
M(1) M(2) M(3)
