// Arrays: subscripts, types of elements, arrays of arrays.
#version 3.7;
#macro Show(S, X) #debug concat(S, " ", str(X, 0, 4), "\n") #end
#declare A = array[2][3] { { 1, 2, 3 }, { 4, 5, 6, }, }
Show("A[1][2]", A[1][2])
Show("A[0.9999999999999][1.9]", A[0.9999999999999][1.9])
Show("dimensions", dimensions(A))
Show("dimension_size", dimension_size(A, 2) + 10*dimension_size(A, 1) + 100*dimension_size(A, 3))
#declare B = array[3];
#ifdef (B[1]) #debug "wrong\n" #else #debug "B[1] is empty\n" #end
#declare B[1] = <1, 2, 3>;
#ifdef (B[1]) #debug "B[1] is set\n" #end
Show("component", B[1].y)
Show("in a subscript", A[A[0][0]][B[1].x])
#undef B[1]
Show("emptied", defined(B[1]))
#declare C = array[2]
#declare C[0] = array[2] { 7, 8 }
#declare C[1] = array[3] { 7, 8, 9 }
Show("of arrays", C[1][2])
Show("size inside", dimension_size(C[1], 1))
#macro Local() #local D[0] = 5; #end
#declare D = array[1];
Local()
Show("open array reached", D[0])
#macro Lost() #local D[0] = 6; #end
Lost()
Show("outer array not reached", D[0])
#declare F = array[2];
#declare F[0] = function(x) { x*2 }
#declare F[1] = function(x) { x*3 }
#declare E = array[1] { sphere { 0, 1 } }
object { E[0] pigment { rgb 1 } }
#declare I = 0;
#while (I < 3) #declare B[I] = I*x; #declare I = I + 1; #end
Show("last", B[2].x)
