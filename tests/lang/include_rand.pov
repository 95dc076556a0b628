// rand.inc can be included by itself.
#version 3.7;
#include "rand.inc"
#debug "ok\n"
