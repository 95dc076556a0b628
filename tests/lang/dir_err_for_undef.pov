// A variable that the body removes ends the loop with an error.
#version 3.7;
#for (I, 1, 3) #undef I #end
