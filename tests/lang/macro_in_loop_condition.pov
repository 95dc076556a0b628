// A call in the condition of a loop is made before each pass.
#version 3.7;
#declare N = 0;
#macro Count() #declare N = N + 1; N #end
#while (Count() < 4) #debug "pass\n" #end
#debug concat(str(N, 0, 0), "\n")
