#version 3.7;
#for (I, 1, 2, 0) #end
