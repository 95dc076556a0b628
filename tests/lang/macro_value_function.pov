// Functions are passed by value: #undef of the parameter leaves the function.
#version 3.7;
#macro M(F) #undef F #end
#declare G = function(x) { x + 1 }
M(G)
#debug concat(str(G(1), 0, 0), "\n")
