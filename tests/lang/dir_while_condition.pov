// The condition of #while is read anew before each pass.
#version 3.7;
#declare I = 0;
#macro Next() I < 3 #end
#while (Next()) #debug str(I, 0, 0) #declare I = I + 1; #end
#debug "\n"
