// More characters than there are.
#version 3.7;
#declare S = substr("abc", 2, 3);
