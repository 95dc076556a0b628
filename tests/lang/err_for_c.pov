// A loop as in C.
#version 3.7;
#for (I = 0; I < 3; I = I + 1)
	sphere { I, 1 }
#end
