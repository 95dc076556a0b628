// The variable keeps the first value beyond the end, behind #break its value, else the start.
#version 3.7;
#for (I, 1, 5, 2) #end #debug str(I, 0, 0)
#for (I, 1, 5) #if (I = 3) #break #end #end #debug str(I, 0, 0)
#for (I, 9, 5) #end #debug str(I, 0, 0)
#debug "\n"
