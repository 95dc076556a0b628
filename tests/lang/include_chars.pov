// chars.inc can be included by itself.
#version 3.7;
#include "chars.inc"
#debug "ok\n"
