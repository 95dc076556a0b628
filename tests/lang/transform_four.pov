// A transformation takes three components.
#version 3.7;
sphere { 0, 1 translate <1, 2, 3, 4> }
