// Arguments may contain calls, directives and text of other macros.
#version 3.7;
#macro Add(A, B) (A + B) #end
#debug concat(str(Add(Add(1, 2), Add(3, Add(4, 5))), 0, 0), "\n")
#debug concat(str(Add((#if (1) 10 #else 20 #end), 1), 0, 0), "\n")
