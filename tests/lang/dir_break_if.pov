// #break within #if closes the #if.
#version 3.7;
#declare I = 0;
#while (1) #declare I = I + 1; #if (I > 2) #if (1) #break #end #end #debug "pass\n" #end
#debug concat(str(I, 0, 0), "\n")
