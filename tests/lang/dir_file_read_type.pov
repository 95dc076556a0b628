// The type of a variable is replaced by that of the datum.
#version 3.7;
#declare A = "text"; #declare B = 5;
#fopen F "dir_file_read_type.txt" read
#read (F, A, B)
#debug concat(str(A, 0, 0), B, "\n")
