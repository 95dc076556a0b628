// A string cannot be compared with a number.
#version 3.7;
#if ("1" = 1) #end
