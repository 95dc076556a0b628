// The parentheses of a call are mandatory.
#version 3.7;
#macro M() 5 #end
#declare A = M;
