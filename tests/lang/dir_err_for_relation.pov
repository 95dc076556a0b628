// The range of #for is read at sum level.
#version 3.7;
#for (I, 1, 3 > 2) #end
