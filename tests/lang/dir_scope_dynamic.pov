// Scope is dynamic: a macro sees the #locals of its caller, and of the caller's caller.
#version 3.7;
#macro Inner() #debug concat(str(A, 0, 0), str(B, 0, 0), "\n") #end
#macro Middle() #local B = 2; Inner() #end
#macro Outer() #local A = 1; Middle() #end
Outer()
