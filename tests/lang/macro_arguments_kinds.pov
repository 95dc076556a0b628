// Arguments are expressions, colours, strings, statements, arrays, functions, identifiers.
#version 3.7;
#macro Num(A) #debug concat(str(A, 0, 1), "\n") #end
#macro Col(A) #debug concat(vstr(5, A, ",", 0, 1), "\n") #end
#macro Txt(A) #debug concat(A, "\n") #end
#macro Obj(A) object { A } #end
#macro Arr(A) #debug concat(str(A[1], 0, 0), "\n") #end
#macro Fun(A) #debug concat(str(A(2), 0, 0), "\n") #end
#macro Tex(A) sphere { 0, 1 texture { A } } #end
#macro Spl(A) #debug concat(str(A(0.5).x, 0, 1), "\n") #end
Num(1 + 2) Num((1 < 2 ? 3 : 4)) Col(rgb <1, 0, 0> transmit 0.5) Txt("a") Txt(concat("b", "c"))
Obj(sphere { 0, 1 }) Arr(array[2] { 5, 6 }) Fun(function(x) { x + 1 })
Tex(texture { pigment { rgb 1 } } texture { pigment { rgbt 1 } }) Spl(spline { 0, 0*x 1, x })
