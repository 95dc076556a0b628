// #range with the limits exchanged matches nothing; the comma may be missing.
#version 3.7;
#switch (5) #range (7, 3) #debug "wrong\n" #range (4 6) #debug "range\n" #break #end
