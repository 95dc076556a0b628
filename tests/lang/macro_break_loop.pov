// #break in a loop within a macro leaves the loop only; in a macro called from a loop, the macro.
#version 3.7;
#macro M() #for (I, 1, 3) #if (I = 2) #break #end #debug str(I, 0, 0) #end #debug "behind\n" #end
M()
#macro N() #break #debug "wrong\n" #end
#for (J, 1, 2) N() #debug str(J, 0, 0) #end
#debug "\n"
