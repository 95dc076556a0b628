// A 2-vector cannot be read into.
#version 3.7;
#declare A = <1, 2>;
#fopen F "dir_file_read_end.txt" read
#read (F, A)
