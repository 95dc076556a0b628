// A string where a vector is wanted.
#version 3.7;
sphere { 0, 1 translate "a" }
