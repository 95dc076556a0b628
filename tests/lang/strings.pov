// Strings: pieces, cases, comparison, numbers.
#version 3.7;
#declare S = concat("Lam", "bert");
#debug concat(S, " ", strupr(S), " ", strlwr(S), " ", substr(S, 2, 3), "\n")
#debug concat(str(strlen(S), 0, 0), " ", str(strcmp("a", "b"), 0, 0), " ", chr(65), str(asc("a"), 0, 0), "\n")
#debug concat(str(val("12.5") + 1, 0, 2), " [", str(pi, 8, 3), "]\n")
