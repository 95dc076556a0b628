// A backslash right before a line end is an error.
#version 3.7;
#debug "one\
two\n"
