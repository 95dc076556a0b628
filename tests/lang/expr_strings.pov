// Strings are compared code by code.
#version 3.7;
#macro Rel(A, B) #debug concat(A, " ", B, " ", str((A < B), 0, 0), str((A <= B), 0, 0), str((A =
	B), 0, 0),
	str((A != B), 0, 0), str((A >= B), 0, 0), str((A > B), 0, 0), "\n") #end
Rel("abc", "abd") Rel("abc", "abc") Rel("abc", "ab") Rel("", "a") Rel("Z", "a")
