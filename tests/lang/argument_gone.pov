// A variable that is passed on, and whose macro ends among the arguments, leaves its value.
// lambert only
#version 3.7;
#macro Show(A, B, C) #debug concat(str(A, 0, 0), " ", str(B, 0, 0), " ", str(C, 0, 0), "\n") #end
#macro Begin() #local V = 3; #local W = array[2] { 4, 5 } Show(V, W[1], #end
#macro Six() 6 #end
Begin() 7)
Begin() Six())
#declare Outer = 8;
#macro Undefine() #undef Outer 9 #end
Show(Outer, Undefine(), 1)
sphere { 0, 1 }
