// shapes.inc can be included by itself.
#version 3.7;
#include "shapes.inc"
#debug "ok\n"
