// Below version 3.5 a byte above 127 of a literal is its own code.
#version 3.4;
#declare S = "äb";
#debug concat(str(strlen(S), 0, 0), " ", str(asc(S), 0, 0), "\n")
