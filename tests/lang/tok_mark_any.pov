€// Any run of bytes above 127 counts as a byte-order mark.
#version 3.7;
#debug concat(str(strlen("Ã¤"), 0, 0), " ", str(asc("Ã¤"), 0, 0), "\n")
