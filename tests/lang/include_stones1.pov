// stones1.inc can be included after colors.inc.
#version 3.7;
#include "colors.inc"
#include "stones1.inc"
#debug "ok\n"
