// #declare of a name that a caller's #local has writes there and makes no global.
#version 3.7;
#macro Inner() #declare L = 9; #end
#macro Outer() #local L = 5; Inner() #debug concat(str(L, 0, 0), "\n") #end
Outer()
#debug concat(str(defined(L), 0, 0), "\n")
