// The operand of #switch must be a float.
#version 3.7;
#switch (x) #case (1) #end
