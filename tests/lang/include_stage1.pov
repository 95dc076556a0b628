// stage1.inc can be included by itself.
#version 3.7;
#include "stage1.inc"
#debug "ok\n"
