// colors.inc can be included by itself.
#version 3.7;
#include "colors.inc"
#debug "ok\n"
