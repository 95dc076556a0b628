// A number is not turned into a string by itself.
#version 3.7;
#debug concat("a", 5, "\n")
