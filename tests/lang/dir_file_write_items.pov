// Items of #write follow each other, with and without commas; directives may stand between.
#version 3.7;
#fopen F "dir_file_write_items.tmp" write
#write (F, "\"a" "b", str(1, 0, 1) #for (I, 1, 3) I, " ", #end concat("x", "y")
	#if (0) "no" #else "yes\"" #end )
#fclose F
#fopen F "dir_file_write_items.tmp" read
#read (F, A)
#debug concat("[", A, "]\n")
