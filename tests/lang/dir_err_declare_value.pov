// A declaration needs a value.
#version 3.7;
#declare A = ;
