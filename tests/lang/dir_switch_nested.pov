// Switches within switches; #break leaves the inner one.
#version 3.7;
#switch (1)
	#case (1)
		#switch (2) #case (1) #debug "a\n" #break #case (2) #debug "b\n" #break #else
			#debug "c\n" #end
		#debug "d\n"
	#break
	#else #debug "e\n"
#end
