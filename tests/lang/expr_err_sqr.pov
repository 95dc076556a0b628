// sqr is no float function.
#version 3.7;
#declare A = sqr(2);
