// A macro of an include file does not find the #locals of that file later, but a global of the
// name.
#version 3.7;
#declare Name = "global";
#include "dir_local_include_macro.inc"
InFile()
