// screen.inc can be included by itself.
#version 3.7;
#include "screen.inc"
#debug "ok\n"
