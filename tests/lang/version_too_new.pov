// A version that is not there yet.
#version 3.8;
