// strcmp gives the difference of the first two codes that differ; the end counts as 0.
#version 3.7;
#debug concat(str(strcmp("a", "c"), 0, 0), " ", str(strcmp("abc", "abc"), 0, 0), "\n")
#debug concat(str(strcmp("abc", "ab"), 0, 0), "\n")
#debug concat(str(strcmp("", "A"), 0, 0), " ", str(strcmp("a", "A"), 0, 0), " ", str(strcmp("",
	""), 0, 0), "\n")
