// While falling through, the operands of #case are evaluated.
#version 3.7;
#switch (1) #case (1) #debug "one\n" #case (undeclared) #end
