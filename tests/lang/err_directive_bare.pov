// A loop without its '#': what follows cannot be told, and nothing more is said.
#version 3.7;
for (I, 1, 3)
	sphere { I, 1 }
#end
sphere { 0, Missing }
