// #include wants a string.
#version 3.7;
#include standard
