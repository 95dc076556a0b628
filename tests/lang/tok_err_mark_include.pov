// A byte-order mark at the start of an include file is illegal.
#version 3.7;
#include "tok_err_mark_include.inc"
