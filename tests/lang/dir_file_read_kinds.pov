// #read: numbers with signs, vectors, strings with escapes, comments.
#version 3.7;
#fopen F "dir_file_read_kinds.txt" read
#read (F, A, B, C, D, E)
#debug concat(str(A, 0, 2), " ", str(B, 0, 2), " ", str(C, 0, 2), " ", vstr(3, D, ",", 0, 1), " ",
	E, "\n")
#read (F, G, H, I)
#debug concat(vstr(2, G, ",", 0, 1), " ", vstr(4, H, ",", 0, 1), " ", str(I.transmit, 0, 9), "\n")
