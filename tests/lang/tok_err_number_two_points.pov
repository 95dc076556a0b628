// A second decimal point is an error.
#version 3.7;
#declare A = 1.5.2;
