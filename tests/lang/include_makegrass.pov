// makegrass.inc can be included by itself.
#version 3.7;
#include "makegrass.inc"
#debug "ok\n"
