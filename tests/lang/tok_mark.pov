// A byte-order mark makes string literals UTF-8.
#version 3.7;
#debug concat(str(strlen("ä"), 0, 0), " ", str(asc("ä"), 0, 0), "\n")
