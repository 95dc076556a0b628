// asc is the code of the first character, 0 for the empty string.
#version 3.7;
#debug concat(str(asc("A"), 0, 0), " ", str(asc("zebra"), 0, 0), " ", str(asc(""), 0, 0), "\n")
