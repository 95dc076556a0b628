// A loop must end in the file it begins in.
#version 3.7;
#include "dir_err_loop_file.inc"
#end
