// A variable that the body makes a string ends the loop with an error.
#version 3.7;
#for (I, 1, 3) #declare I = "text"; #end
