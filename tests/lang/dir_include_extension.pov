// The extension .inc is added, also to names with another one; a name may be computed.
#version 3.7;
#include "dir_include_extension"
#include "dir_include_extension.inc"
#declare N = "dir_include_";
#include concat(N, "extension")
