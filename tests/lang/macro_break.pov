// #break outside of loops returns from the macro.
#version 3.7;
#macro M(N) #if (N > 1) #if (1) #debug "early\n" #break #end #end #debug "late\n" #end
M(2) M(1)
