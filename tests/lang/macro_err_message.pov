// An error in a body shows the calls that led there.
#version 3.7;
#macro Inner(R) sphere { 0, R, R } #end
#macro Outer(R) Inner(R + 1) #end
Outer(1)
