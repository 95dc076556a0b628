// math.inc can be included by itself.
#version 3.7;
#include "math.inc"
#debug "ok\n"
