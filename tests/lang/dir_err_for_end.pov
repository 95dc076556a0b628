// #for needs an end.
#version 3.7;
#for (I, 1) #end
