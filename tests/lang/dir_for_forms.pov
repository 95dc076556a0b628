// #for: the step may be missing, commas between start and end, too.
#version 3.7;
#for (I, 1, 3) #debug str(I, 0, 0) #end
#for (I 1 3) #debug str(I, 0, 0) #end
#for (I, 0, 1, 0.5) #debug str(I, 0, 1) #end
#for (I, 2, 0, -1) #debug str(I, 0, 0) #end
#debug "\n"
