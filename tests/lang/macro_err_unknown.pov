// A call of a macro that is not defined.
#version 3.7;
#macro RoundBox(A) #end
RoundBoxx(1)
