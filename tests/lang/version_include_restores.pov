// A standard include works in 3.5 and gives the version back.
#version 3.6;
#include "consts.inc"
#debug concat(str(version, 0, 2), "\n")
#version 3.7;
#include "colors.inc"
#debug concat(str(version, 0, 2), "\n")
