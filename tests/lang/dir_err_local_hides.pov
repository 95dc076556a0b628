// The name is entered before the value is read: the new local hides the global of that name.
#version 3.7;
#declare A = 1;
#macro M() #local A = A + 1; #end
M()
