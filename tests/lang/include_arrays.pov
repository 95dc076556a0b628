// arrays.inc can be included by itself.
#version 3.7;
#include "arrays.inc"
#debug "ok\n"
