// End and step are evaluated once.
#version 3.7;
#declare E = 3; #declare S = 1;
#for (I, 1, E, S) #debug str(I, 0, 0) #declare E = 9; #declare S = 5; #end
#debug "\n"
