// stdinc.inc can be included by itself.
#version 3.7;
#include "stdinc.inc"
#debug "ok\n"
