// Settings and declarations that an include file makes persist.
#version 3.7;
#include "dir_include_nested.inc"
#debug concat(str(version, 0, 1), str(FromFile, 0, 0), "\n")
