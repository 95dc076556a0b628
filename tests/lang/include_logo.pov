// logo.inc can be included by itself.
#version 3.7;
#include "logo.inc"
#debug "ok\n"
