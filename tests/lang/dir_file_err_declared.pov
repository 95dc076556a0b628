// The name of a file must not be declared.
#version 3.7;
#declare F = 5;
#fopen F "dir_file_read_end.txt" read
