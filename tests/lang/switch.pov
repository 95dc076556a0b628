// #switch falls through without #break; #range is closed.
#version 3.7;
#macro Say(N)
	#switch (N)
		#case (1) #debug "one "
		#case (2) #debug "two " #break
		#range (3, 5) #debug "some " #break
		#else #debug "many "
	#end
	#debug "\n"
#end
Say(1) Say(2) Say(5) Say(9)
