// A name of a file without its quotes.
#version 3.7;
#include colors.inc
