// A column of zeros gets a 1 in its diagonal.
#version 3.7;
#include "transforms.inc"
#declare T = transform { matrix <1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0> }
#debug concat(vstr(3, vtransform(<1, 2, 3>, T), " ", 0, 6), "\n")
