// An element of an array without a type cannot be read into.
#version 3.7;
#declare A = array[2];
#fopen F "dir_file_read_end.txt" read
#read (F, A[0])
