// The first name of a #read that meets the end of the file counts as defined, later ones do not.
#version 3.7;
global_settings { assumed_gamma 1 }
#fopen F "dir_file_read_empty.txt" read
#read (F, A, B, C)
#debug concat(str(defined(A), 0, 0), str(defined(B), 0, 0), str(defined(C), 0, 0), str(defined(F), 0, 0), "\n")
#fopen F "dir_file_read_comma_end.txt" read
#read (F, D) #read (F, E, G)
#debug concat(str(D, 0, 0), str(defined(E), 0, 0), str(defined(G), 0, 0), str(defined(F), 0, 0), "\n")
sphere { 0, 1 }
