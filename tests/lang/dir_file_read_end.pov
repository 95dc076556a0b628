// At the end of the file the handle is gone, and variables not read are undeclared.
#version 3.7;
#fopen F "dir_file_read_end.txt" read
#declare C = 9;
#read (F, A, B, C, D)
#debug concat(str(A, 0, 0), str(B, 0, 0), str(C, 0, 0), str(defined(D), 0, 0), str(defined(F), 0,
	0), "\n")
