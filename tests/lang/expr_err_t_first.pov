// A declared value cannot begin with the vector t.
#version 3.7;
#declare A = t*2;
