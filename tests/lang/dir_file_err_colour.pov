// A colour identifier cannot be read into.
#version 3.7;
#declare A = rgb 1;
#fopen F "dir_file_read_end.txt" read
#read (F, A)
