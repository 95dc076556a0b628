// woods.inc can be included by itself.
#version 3.7;
#include "woods.inc"
#debug "ok\n"
