// More than 200 characters are cut to 156 and "..."
#version 3.7;
#declare S = "abcdefghi ";
#declare S = concat(S, S, S, S, S, S, S, S, S, S, S, S, S, S, S, S, S, S, S, S);
#debug concat(S, "\n")
#debug concat(S, "x\n")
#debug "\n"
