// CR, LF, CR LF and LF CR each count as one newline, in strings too.
#version 3.7;
#debug concat(str(strlen("ab"), 0, 0), str(asc(substr("ab", 2, 1)), 3, 0), "\n")
#debug concat(str(strlen("a
b"), 0, 0), str(asc(substr("a
b", 2, 1)), 3, 0), "\n")
#debug concat(str(strlen("a
b"), 0, 0), str(asc(substr("a
b", 2, 1)), 3, 0), "\n")
#debug concat(str(strlen("a
b"), 0, 0), str(asc(substr("a
b", 2, 1)), 3, 0), "\n")
// A CR alone ends this comment #debug "after CR\n"
