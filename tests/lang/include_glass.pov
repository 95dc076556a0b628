// glass.inc can be included by itself.
#version 3.7;
#include "glass.inc"
#debug "ok\n"
