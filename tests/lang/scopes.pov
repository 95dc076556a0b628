// Dynamic scope, #declare and #local, parameters by reference and by value.
#version 3.7;
#macro Show(S, X) #debug concat(S, " ", str(X, 0, 4), "\n") #end

#declare G = 1;
#macro Inner() #declare G = G + 1; #declare L = 9; #end
#macro Outer() #local L = 5; Inner() Show("L in Outer", L) #end
Outer()
Show("G", G)
#ifdef (L) #debug "L is global\n" #else #debug "L is gone\n" #end

#macro ByReference(P) #declare P = P + 10; #local P = P + 100; #end
ByReference(G)
Show("G after ByReference(G)", G)
ByReference((G))
ByReference(G + 0)
ByReference(+G)
Show("G after by value", G)

#macro ChangeType(P) #declare P = "text"; #end
#declare H = 4;
ChangeType(H)
#debug concat("H is ", H, "\n")

#declare A = array[3] { 1, 2, 3 }
ByReference(A[1])
Show("A[1]", A[1])
#macro SetAll(B) #local I = 0; #while (I < dimension_size(B, 1)) #declare B[I] = 7 + I; #local I = I + 1; #end #end
SetAll(A)
Show("A[0]", A[0])
Show("A[2]", A[2])
#declare B = A;
#declare B[0] = 0;
Show("A[0] is independent", A[0])

#macro Twice(P) ByReference(P) ByReference(P) #end
#declare T = 0;
Twice(T)
Show("reference to reference", T)

#macro ReturnsLocal() #local R = 6; R #end
#macro Modify(P) #declare P = P + 1; #end
Modify(ReturnsLocal())
#macro ReturnsGlobal() T #end
Modify(ReturnsGlobal())
Show("T through a macro", T)

#declare Hidden = 3;
#macro Param(Hidden) #undef Hidden Show("behind the parameter", Hidden) #end
Param(8)
#local Top = 2;
#macro SeesTop() Show("Top", Top) #end
SeesTop()
