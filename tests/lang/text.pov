// Strings: escapes, lines, wrapping and cutting of #debug text.
#version 3.7;
#debug "tab\there \\ \' \" \u0041\n"
#debug "two
lines\n"
#debug "no newline yet "
#debug "and now\n"
#declare S10 = "123456789 ";
#declare S50 = concat(S10, S10, S10, S10, S10);
#debug concat(S50, S50, S50, "\n")
#debug concat(S50, S50, S50, S50, "\n")
#debug concat(S50, S50, S50, S50, S50, "\n")
#debug "\n"
#debug concat(S50, S50)
#debug concat(S50, S50, "\n")
#declare X50 = "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx";
#debug concat(X50, X50, X50)
#debug concat(X50, "\n")
#debug concat(str(strlen("a\tb"), 0, 0), str(asc("\\"), 0, 0), "\n")
#render "rendered\n"
#statistics "counted\n"
#debug "lost"
