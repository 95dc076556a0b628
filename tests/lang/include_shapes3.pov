// shapes3.inc can be included by itself.
#version 3.7;
#include "shapes3.inc"
#debug "ok\n"
