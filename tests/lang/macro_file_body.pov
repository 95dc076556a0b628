// The body of a macro from an include file is read from there when called later.
#version 3.7;
#include "macro_file_body.inc"
#for (I, 1, 3) #debug concat(str(Square(I), 0, 0), " ") #end
Nested(2)
