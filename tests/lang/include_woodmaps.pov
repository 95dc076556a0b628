// woodmaps.inc can be included by itself.
#version 3.7;
#include "woodmaps.inc"
#debug "ok\n"
