// Loops count and nest; #break leaves the innermost.
#version 3.7;
#declare I = 0;
#while (I < 3)
	#for (J, I, 2)
		#if (J = 2) #break #end
		#debug concat(str(I, 0, 0), str(J, 0, 0), "\n")
	#end
	#declare I = I + 1;
#end
#for (K, 3, 1, -0.5) #debug concat(str(K, 0, 1), "\n") #end
