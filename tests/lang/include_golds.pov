// golds.inc can be included by itself.
#version 3.7;
#include "golds.inc"
#debug "ok\n"
