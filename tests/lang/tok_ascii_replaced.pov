// In ASCII each byte above 127 of a literal becomes a space, from version 3.5 on.
#version 3.7;
#declare S = "äb";
#debug concat(str(strlen(S), 0, 0), " ", str(asc(S), 0, 0), " [", S, "]\n")
