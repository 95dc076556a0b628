// #fclose ignores what is no file; a handle may be opened again.
#version 3.7;
#declare A = 5;
#fclose A
#fclose Nothing
#fopen F "dir_file_close.tmp" write
#write (F, 1) #fclose F
#debug concat(str(defined(F), 0, 0), str(A, 0, 0), "\n")
