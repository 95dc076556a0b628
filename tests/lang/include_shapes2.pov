// shapes2.inc can be included after shapes.inc.
#version 3.7;
#include "shapes.inc"
#include "shapes2.inc"
#debug "ok\n"
