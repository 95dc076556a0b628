// Behind #break the operands of #case are not evaluated.
#version 3.7;
#switch (1) #case (1) #debug "one\n" #break #case (undeclared) #range (undeclared, 1) #end
