// rad_def.inc can be included by itself.
#version 3.7;
#include "rad_def.inc"
#debug "ok\n"
