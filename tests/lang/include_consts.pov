// consts.inc can be included by itself.
#version 3.7;
#include "consts.inc"
#debug "ok\n"
