// Arrays of arrays, of objects, of textures, of strings; lower-case names.
#declare A = array[2][3] {{1,2,3},{4,5,6}}
#declare B = array[2] { A, A }
#debug concat(str(B[1][1][2],0,0), str(dimensions(B),0,0), str(dimension_size(A,2),0,0), "\n")
#local L = 4; #undef L #ifndef (L) #debug "gone\n" #end
#macro Set(X) #declare X = X + 1; #end
#declare Q = 1; Set(Q) Set(Q) #debug concat(str(Q,0,0),"\n")
#declare Arr = array[5]; #declare Arr[0] = sphere { 0, 1 } #declare Arr[1] = box { 0, 1 }
object { Arr[0] } object { Arr[1] translate x } union { object { Arr[0] } object { Arr[1] } }
#declare Tx = array[2] { texture { pigment { rgb 1 } }, texture { pigment { rgb 0 } } }
sphere { 0, 1 texture { Tx[1] } }
#declare St = array[3] { "a", "b", "c" } #declare i = 0;
#while (i < dimension_size(St,1)) #debug St[i] #declare i = i + 1; #end #debug "\n"
