// The escapes of a literal: codes of single characters, quotes, a backslash, \uXXXX.
#version 3.7;
#declare S = "\a\b\f\n\r\t\v\\\'\"\u0041";
#debug concat(str(strlen(S), 0, 0), ":")
#for (I, 1, strlen(S)) #debug concat(" ", str(asc(substr(S, I, 1)), 0, 0)) #end
#debug "\n"
