// Anything but a single identifier is passed by value.
#version 3.7;
#macro Set(P) #declare P = 9; #end
#declare A = 1; #declare V = <1, 2, 3>; #declare S = "text";
Set(A + 0) Set((A)) Set(+A) Set(-A) Set(V.x) Set(5) Set(concat(S, ""))
#debug concat(str(A, 0, 0), vstr(3, V, ",", 0, 0), S, "\n")
