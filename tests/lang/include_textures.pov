// textures.inc can be included by itself.
#version 3.7;
#include "textures.inc"
#debug "ok\n"
