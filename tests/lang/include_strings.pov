// strings.inc can be included by itself.
#version 3.7;
#include "strings.inc"
#debug "ok\n"
