// #debug wants a string.
#version 3.7;
#debug 5
