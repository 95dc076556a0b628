// An item of #write cannot begin with a colour identifier.
#version 3.7;
#declare C = rgb 1;
#fopen F "dir_file_err_write_colour.txt" append
#write (F, C)
