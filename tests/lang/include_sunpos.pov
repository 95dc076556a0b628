// sunpos.inc can be included by itself.
#version 3.7;
#include "sunpos.inc"
#debug "ok\n"
