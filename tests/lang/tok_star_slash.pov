// Outside of a comment "*/" is two tokens.
#version 3.7;
#if (0) */ * / #end
#debug "passed\n"
