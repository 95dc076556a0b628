// stars.inc can be included by itself.
#version 3.7;
#include "stars.inc"
#debug "ok\n"
