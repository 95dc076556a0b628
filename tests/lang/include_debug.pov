// debug.inc can be included by itself.
#version 3.7;
#include "debug.inc"
#debug "ok\n"
