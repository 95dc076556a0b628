// Too few arguments.
#version 3.7;
#declare A = sin();
