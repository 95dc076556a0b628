// \" does not end a literal; a backslash before the end is two characters.
#version 3.7;
#debug "say \"hello\" \\\n"
#debug concat(str(strlen("\""), 0, 0), str(strlen("\\"), 0, 0), str(strlen(""), 0, 0), "\n")
