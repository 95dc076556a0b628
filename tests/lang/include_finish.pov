// finish.inc can be included by itself.
#version 3.7;
#include "finish.inc"
#debug "ok\n"
