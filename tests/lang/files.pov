// #fopen, #write, #read.
#version 3.7;
#fopen Out "files_test.tmp" write
#write (Out, "1.5, -2, <1,2,3>, \"te\\txt\", ", 3.25, ",", <1,2,3>, 4, 5 "\n")
#fclose Out
#fopen In "files_test.tmp" read
#read (In, A, B) #read (In, V, S)
#debug concat(str(A, 0, 3), " ", str(B, 0, 3), " ", vstr(3, V, ",", 0, 1), " ", S, "\n")
#while (defined(In))
	#read (In, X)
	#debug concat(vstr(3, X, ",", 0, 2), "\n")
#end
#fopen Out "files_test.tmp" append
#write (Out, "7 8 9, ")
#fclose Out
#fopen In "files_test.tmp" read
#declare N = 0;
#while (defined(In)) #read (In, X) #declare N = N + 1; #end
#debug concat("data ", str(N, 0, 0), "\n")
#fopen Out "files_test.tmp" write
#write (Out, "#declare Written = 42;\n")
#fclose Out
#include "files_test.tmp"
#debug concat(str(Written, 0, 0), "\n")
#fclose Nothing
