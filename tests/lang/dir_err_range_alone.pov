// #range without #switch.
#version 3.7;
#range (1, 2)
