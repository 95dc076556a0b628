// meshmaker.inc can be included by itself.
#version 3.7;
#include "meshmaker.inc"
#debug "ok\n"
