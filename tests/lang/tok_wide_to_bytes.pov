// Codes above 127 become spaces where a string is turned into bytes.
#version 3.7;
#declare S = "[\u00e4\u20ac\u0041]";
#debug concat(str(strlen(S), 0, 0), S, "\n")
