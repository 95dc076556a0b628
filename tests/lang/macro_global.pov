// A macro is always global, wherever it is defined.
#version 3.7;
#macro Outer() #macro Inner() #debug "inner\n" #end #end
Outer() Inner()
#include "macro_global.inc"
FromFile()
