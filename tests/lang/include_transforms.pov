// transforms.inc can be included by itself.
#version 3.7;
#include "transforms.inc"
#debug "ok\n"
