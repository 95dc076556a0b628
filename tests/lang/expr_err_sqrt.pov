// sqrt of a negative value.
#version 3.7;
#declare A = sqrt(-1);
