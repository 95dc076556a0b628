// The #end of an inner block is missing: the outer one has none, but one sees which by the indents.
#version 3.7;
#macro Thing(X)
	#if (X > 1)
		sphere { 0, X }
	#else
		box { 0, X }
#end
Thing(3)
