// A comment may stand between # and the directive word.
#version 3.7;
# /* a */ // b
 declare A = 1;
#/**/debug concat(str(A, 0, 0), "\n")
