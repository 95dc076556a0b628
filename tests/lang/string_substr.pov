// substr counts from 1; no characters are nothing, even just behind the end.
#version 3.7;
#declare S = "abcdef";
#debug concat("[", substr(S, 1, 2), "] [", substr(S, 6, 1), "] [", substr(S, 7, 0), "]\n")
#debug concat("[", substr(S, 2.9, 3.9), "]\n")
