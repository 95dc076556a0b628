// matrix: the images of the axes and the place of the origin, commas optional.
#version 3.7;
#include "transforms.inc"
#declare T = transform { matrix <1, 0, 0, 0.5, 1, 0, 0, 0, 2, 10, 20, 30> }
#debug concat(vstr(3, vtransform(<1, 2, 3>, T), " ", 0, 6), "\n")
#declare T = transform { matrix <0 1 0 1 0 0 0 0 1 0 0 0> }
#debug concat(vstr(3, vtransform(<1, 2, 3>, T), " ", 0, 6), "\n")
