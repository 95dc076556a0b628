// Without a comma the token behind a datum is lost.
#version 3.7;
#fopen F "dir_file_read_commas.txt" read
#read (F, A) #read (F, B)
#debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
#while (defined(F)) #read (F, C) #debug concat(str(C, 0, 0), " ") #end
#debug "\n"
