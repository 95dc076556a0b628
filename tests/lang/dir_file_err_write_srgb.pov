// An item of #write cannot begin with a colour word.
#version 3.7;
#fopen F "dir_file_err_write_colour.txt" append
#write (F, srgbt <1, 0, 0, 0>)
