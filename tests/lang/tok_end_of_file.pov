// The last line need not end in a newline.
#version 3.7;
#debug "last line\n"
