// stones2.inc can be included after colors.inc.
#version 3.7;
#include "colors.inc"
#include "stones2.inc"
#debug "ok\n"
