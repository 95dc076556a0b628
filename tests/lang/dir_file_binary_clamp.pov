// Values beyond the range of a binary format are clamped, others rounded.
#version 3.4;
#fopen F "dir_file_binary_clamp.tmp" write
#write (F, "\"", uint8 300, uint8 65.5, uint8 65.4, sint8 1000, uint16be 99999, uint8 94.99, "\"")
#fclose F
#fopen F "dir_file_binary_clamp.tmp" read
#read (F, A)
#declare I = 1;
#while (I <= strlen(A)) #debug concat(str(asc(substr(A, I, 1)), 0, 0), " ") #declare I = I + 1; #end
#debug "\n"
