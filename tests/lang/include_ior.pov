// ior.inc can be included by itself.
#version 3.7;
#include "ior.inc"
#debug "ok\n"
