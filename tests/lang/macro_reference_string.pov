// A lone string or object identifier is passed by reference, too.
#version 3.7;
#macro Set(P) #declare P = 5; #end
#declare S = "text"; Set(S)
#declare O = sphere { 0, 1 } Set(O)
#declare T = texture { pigment { rgb 1 } } Set(T)
#debug concat(str(S, 0, 0), str(O, 0, 0), str(T, 0, 0), "\n")
