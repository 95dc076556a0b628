// What ends a macro, a loop or an included file may undefine or redefine what it made there.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Undef_Array() #local A = array[2] #undef A #end
#macro Undef_Filled() #local A = array[2] { 1, 2 } #undef A #end
#macro Undef_Nested() #local A = array[1] #local A[0] = array[2] { 3, 4 } #undef A #end
#macro Undef_Element() #local A = array[2] { 1, 2 } #undef A[0] #end
#macro Undef_Float() #local A = 1; #undef A #end
#macro Undef_Vector() #local A = <1, 2, 3>; #undef A #end
#macro Undef_String() #local A = "text" #undef A #end
#macro Undef_Colour() #local A = rgb 1; #undef A #end
#macro Undef_Object() #local A = sphere { 0, 1 } #undef A #end
#macro Undef_Texture() #local A = texture { pigment { rgb 1 } } #undef A #end
#macro Undef_Function() #local A = function(x) { x } #undef A #end
#macro Undef_Spline() #local A = spline { linear_spline 0, <1, 2, 3> 1, <4, 5, 6> } #undef A #end
#macro Undef_Parameter(A) #undef A #end
#macro Undef_Outer() #undef Outer #end
#macro Inner() #local A = array[2] #undef A #end
#macro Nested() #local A = array[3] Inner() Inner() #undef A #end
#macro Redefine_Kind() #local A = array[2] #undef A #local A = "text" #end
#macro Local_Last() #local A = array[2] { 1, 2 } #end
#macro Declare_Last() #declare Left = array[2] { 1, 2 } #end
#macro Loop() #for (I, 1, 3) #local A = array[2] #undef A #end #end
#macro Choose(N) #if (N) #local A = array[2] #undef A #else #local A = 1; #undef A #end #end
#for (I, 1, 20)
	Undef_Array() Undef_Filled() Undef_Nested() Undef_Element() Undef_Float() Undef_Vector() Undef_String()
	Undef_Colour() Undef_Object() Undef_Texture() Undef_Function() Undef_Spline() Nested()
	Redefine_Kind() Local_Last() Declare_Last() Loop() Choose(0) Choose(1)
	#declare Outer = array[2] { 5, 6 }
	Undef_Outer()
	Undef_Parameter(7)
	#include "undef_last.inc"
#end
#debug concat(str(Left[1], 0, 0), " ", str(defined(Outer), 0, 0), str(defined(A), 0, 0), "\n")
sphere { 0, 1 }
