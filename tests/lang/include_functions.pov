// functions.inc can be included by itself.
#version 3.7;
#include "functions.inc"
#debug "ok\n"
