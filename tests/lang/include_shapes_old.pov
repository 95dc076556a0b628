// shapes_old.inc can be included by itself.
#version 3.7;
#include "shapes_old.inc"
#debug "ok\n"
