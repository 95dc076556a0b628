// What stands behind a datum is lost, comma or not.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Try(Text)
	#fopen Out "lost.txt" write #write (Out, Text) #fclose Out
	#fopen In "lost.txt" read
	#while (defined(In)) #read (In, V) #debug concat(str(V, 0, 0), " ") #end
	#debug "\n"
#end
Try("1 2 3 4 5 6 7") Try("-1 -2 -3 -4") Try("1+1") Try("1;2") Try("1, 2, 3")
#fopen Out "lost.txt" write #write (Out, "\"a\" \"b\" \"c\"") #fclose Out
#fopen In "lost.txt" read
#while (defined(In)) #read (In, S) #debug concat(S, "\n") #end
sphere { 0, 1 }
