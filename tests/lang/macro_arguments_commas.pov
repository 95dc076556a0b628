// Commas between arguments are optional, one behind the last is tolerated.
#version 3.7;
#macro M(A B, C) #debug concat(str(A, 0, 0), str(B, 0, 0), str(C, 0, 0), "\n") #end
M(1, 2, 3) M(1 2 3) M(1, 2, 3,)
#macro N() #debug "none\n" #end
N()
