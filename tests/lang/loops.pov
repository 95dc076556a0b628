// #while, #for, #break, #switch.
#version 3.7;
#declare I = 0;
#while (I < 3) #debug concat("while ", str(I, 0, 0), "\n") #declare I = I + 1; #end
#for (J, 0, 1, 0.25) #debug concat("for ", str(J, 0, 2), "\n") #end
#debug concat("after ", str(J, 0, 2), "\n")
#for (J, 3, 1) #debug "never\n" #end
#debug concat("after ", str(J, 0, 2), "\n")
#for (J, 3, 1, -1) #debug concat("down ", str(J, 0, 0), "\n") #if (J = 2) #break #end #end
#debug concat("after ", str(J, 0, 2), "\n")
#declare N = 0; #for (J, 0, 1, 0.1) #declare N = N + 1; #end
#debug concat("passes ", str(N, 0, 0), "\n")
#for (J, 1, 9) #debug concat("jump ", str(J, 0, 0), "\n") #declare J = J + 3; #end
#for (A, 1, 2) #for (B, 1, 2) #debug concat(str(10*A+B, 0, 0), "\n") #end #end
#macro Switch(X)
	#switch (X)
		#case (1) #debug "one " #break
		#case (2) #debug "two "
		#case (3) #debug "three " #break
		#range (4, 6) #debug "range "
		#else #debug "else "
	#end
	#debug "\n"
#end
#for (K, 0, 7) Switch(K) #end
Switch(4.5) Switch(6.00000000001) Switch(2.00000000001)
#switch (1) #case (5) #while (0) #break #end #break #case (1) #if (1) #debug "in if" #break #end #debug "no" #end
#debug "\n"
#if (0) a "string" /* #end */ 1.5 #if (1) #else #end #while (1) #end #switch (3) #case (3) #end
	#macro X() #end #elseif (1) #debug "elseif\n" #elseif (undeclared) #else #debug "wrong\n" #end
#ifdef (Nothing) #debug "wrong\n" #elseif (2) #debug "elseif behind ifdef\n" #end
#ifndef (Nothing) #debug "ifndef\n" #end
#ifdef (sphere) #debug "wrong\n" #else #debug "reserved\n" #end
#debug concat(str(defined(I), 0, 0), str(defined(Nothing), 0, 0), "\n")
