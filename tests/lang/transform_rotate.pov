// rotate turns about x, then y, then z; 90*z takes x to y.
#version 3.7;
#include "transforms.inc"
#declare T = transform { rotate 90*z }
#debug concat(vstr(3, vtransform(x, T), " ", 0, 6), "\n")
#declare T = transform { rotate <30, 40, 50> }
#debug concat(vstr(3, vtransform(<1, 2, 3>, T), " ", 0, 9), "\n")
#debug concat(vstr(3, vrotate(<1, 2, 3>, <30, 40, 50>), " ", 0, 9), "\n")
