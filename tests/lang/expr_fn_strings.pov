// asc, strlen, strcmp, val.
#version 3.7;
#debug concat(str(asc("A"), 0, 0), str(asc(""), 2, 0), str(strlen("abc"), 2, 0), str(strcmp("a",
	"c"), 3, 0),
	str(strcmp("abc", "ab"), 3, 0), str(strcmp("", ""), 2, 0), "\n")
#debug concat(str(val("12.5"), 0, 2), " ", str(val(" -3e2x"), 0, 2), " ", str(val("none"), 0, 2),
	" ",
	str(val("0x1F"), 0, 2), " ", str(val("inf"), 0, 2), "\n")
