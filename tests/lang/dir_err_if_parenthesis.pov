// The condition stands in parentheses.
#version 3.7;
#if 1 #end
