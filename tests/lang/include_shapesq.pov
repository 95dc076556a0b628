// shapesq.inc can be included after shapes.inc.
#version 3.7;
#include "shapes.inc"
#include "shapesq.inc"
#debug "ok\n"
