// A parameter may have the name of an identifier, which it hides during the call.
#version 3.7;
#declare A = "outer";
#macro M(A) #debug concat(str(A, 0, 0), "\n") #end
M(5)
#debug concat(A, "\n")
