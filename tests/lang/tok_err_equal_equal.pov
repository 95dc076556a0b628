// There is no == operator.
#version 3.7;
#if (1 == 1) #end
