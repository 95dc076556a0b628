// Macro arguments: by reference when they are names, so a macro can change them; locals hide.
#version 3.7;
#macro Double(X) #declare X = 2 * X; #end
#macro Twice(X, Y) (X + Y) * 2 #end
#macro Fact(N) #if (N < 2) 1 #else (N * Fact(N - 1)) #end #end
#declare A = 3;
Double(A)
#debug concat(str(A, 0, 0), " ", str(Twice(1, A), 0, 0), " ", str(Fact(6), 0, 0), "\n")
#macro Hide() #local A = 100; #debug concat(str(A, 0, 0), "\n") #end
Hide()
#debug concat(str(A, 0, 0), "\n")
