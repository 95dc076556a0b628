// An include file may open a block that the including file closes.
#version 3.7;
#include "dir_include_block.inc"
#debug "inside\n"
#end
#debug "behind\n"
