// #local of a name that an outer table has makes a new one.
#version 3.7;
#declare A = 1;
#macro M() #local A = 2; #debug concat(str(A, 0, 0), "\n") #end
M()
#debug concat(str(A, 0, 0), "\n")
