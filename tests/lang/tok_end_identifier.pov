// An identifier may be the last thing of an include file, without a newline.
#version 3.7;
#declare Five = 5;
#declare A = 1 + #include "tok_end_identifier.inc";
#debug concat(str(A, 0, 0), "\n")
