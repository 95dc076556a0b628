// The binary formats of #write, read back as the codes of a string.
#version 3.7;
#fopen F "dir_file_binary.tmp" write
#write (F, "\"", uint8 65, 66, uint8 67 68.4, uint8 <69, 70, 71.5>, "\",")
#write (F, "\"", sint16be 16706, sint16le 16706, uint16be 17219, uint16le 17219, sint32be
	1094861636,
	sint32le 1094861636, sint8 97, "\"")
#fclose F
#fopen F "dir_file_binary.tmp" read
#read (F, A, B)
#debug concat(A, " ", B, "\n")
