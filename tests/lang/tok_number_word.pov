// A number has no suffix: the letters behind it are a word.
#version 3.7;
#declare x5 = 7;
#declare q = 3;
#macro Two(A B) #debug concat(str(A, 0, 0), " ", str(B, 0, 0), "\n") #end
Two(5q)
Two(0x5)
