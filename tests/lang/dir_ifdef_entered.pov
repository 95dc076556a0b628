// While its first value is being read an identifier is declared, though it has no value.
#version 3.7;
#declare A = (#debug concat(str(defined(A), 0, 0), "\n") #ifdef (A) #debug "declared\n" #end 1);
#macro M() #local A = (#debug concat(str(defined(A), 0, 0), "\n") 2); #undef A #debug concat(str(A,
	0, 0), "\n") #end
M()
