// A negative number of characters.
#version 3.7;
#declare S = substr("abc", 2, -1);
