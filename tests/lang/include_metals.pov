// metals.inc can be included by itself.
#version 3.7;
#include "metals.inc"
#debug "ok\n"
