// A vector where a float is wanted is an error.
#version 3.7;
sphere { 0, <1, 2, 3> }
