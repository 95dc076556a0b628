// What #write writes, read back as strings.
#version 3.7;
#fopen F "dir_file_write_text.tmp" write
#write (F, "\"", 1.5, " ", 1/3, " ", 1e20, " ", 123456789, " ", -0.00001, "\",\n\"")
#write (F, <1, 2>, <1, 2, 3.5>, <1, 2, 3, 4> "|", <.1, .2, .3, .4, .5>, "\"")
#fclose F
#fopen F "dir_file_write_text.tmp" read
#read (F, A, B)
#debug concat("[", A, "]\n[", B, "]\n")
