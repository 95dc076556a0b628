#version 3.7;
#declare S = "12345678";
#while (1)
	#declare S = concat(S, S);
#end
