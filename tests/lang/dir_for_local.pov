// The variable is local to the macro or file of the loop.
#version 3.7;
#declare I = 7;
#macro M() #for (I, 1, 2) #debug str(I, 0, 0) #end #end
M()
#debug concat(str(I, 0, 0), "\n")
