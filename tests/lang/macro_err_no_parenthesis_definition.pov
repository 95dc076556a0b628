// The parentheses of a definition are mandatory.
#version 3.7;
#macro M #end
