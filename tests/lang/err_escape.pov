#version 3.7;
#debug "a\qb\n"
