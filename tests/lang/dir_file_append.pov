// append adds to what is there, write begins anew.
#version 3.7;
#fopen F "dir_file_append.tmp" write
#write (F, "1,") #fclose F
#fopen F "dir_file_append.tmp" append
#write (F, "2,") #fclose F
#fopen F "dir_file_append.tmp" read
#read (F, A, B) #fclose F
#debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
#fopen F "dir_file_append.tmp" write
#write (F, "7,8") #fclose F
#fopen F "dir_file_append.tmp" read
#read (F, A, B)
#debug concat(str(A, 0, 0), str(B, 0, 0), "\n")
