// #undef removes the innermost identifier of that name, of any type.
#version 3.7;
#declare A = 1; #declare B = "s"; #declare C = array[1] { 1 } #macro D() #end
#macro M() #local A = 2; #undef A #debug concat(str(A, 0, 0), "\n") #end
M()
#undef A #undef B #undef C #undef D
#debug concat(str(defined(A) + defined(B) + defined(C) + defined(D), 0, 0), "\n")
