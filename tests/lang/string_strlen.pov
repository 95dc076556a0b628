// strlen counts characters; a line end in a literal is one.
#version 3.7;
#debug concat(str(strlen(""), 0, 0), " ", str(strlen("a\\b"), 0, 0), " ", str(strlen("a
b"), 0, 0), "\n")
