// The condition of #if must be a float.
#version 3.7;
#if (<1, 2, 3>) #end
