// '#' before a float is an error.
#version 3.7;
#pi
