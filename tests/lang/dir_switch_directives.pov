// Directives may stand between #switch and its first #case.
#version 3.7;
#switch (2) #declare A = 2; #debug "before\n" #case (A) #debug "case\n" #end
