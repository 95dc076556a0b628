// A global that a macro gives back as an argument is passed by reference, its local by value.
#version 3.7;
#macro Set(P) #declare P = P + 1; #end
#declare G = 1;
#macro Global() G #end
#macro Local() #local L = 5; L #end
Set(Global()) Set(Local())
#debug concat(str(G, 0, 0), str(defined(L), 0, 0), "\n")
