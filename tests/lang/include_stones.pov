// stones.inc can be included after colors.inc.
#version 3.7;
#include "colors.inc"
#include "stones.inc"
#debug "ok\n"
