// UTF-8 sequences of 1 to 4 bytes are one code each; above 0xFFFF it is 0xFFFD.
#version 3.7;
#macro Code(S) #debug concat(str(strlen(S), 0, 0), " ", str(asc(S), 0, 0), "\n") #end
Code("A") Code("") Code("€") Code("😀")
Code("￿")
