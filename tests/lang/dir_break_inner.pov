// #break leaves the innermost loop.
#version 3.7;
#for (I, 1, 2) #for (J, 1, 9) #if (J > 2) #break #end #debug concat(str(10*I + J, 0, 0), " ") #end
	#end
#debug "\n"
