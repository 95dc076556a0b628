// The operand of #switch and #case is a full expression.
#version 3.7;
#switch ("a" = "a") #case (2 > 3) #debug "wrong\n" #break #case (2 < 3) #debug "true\n" #break #end
