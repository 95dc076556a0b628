// What was opened to read cannot be written.
#version 3.7;
#fopen F "dir_file_read_end.txt" read
#write (F, 1)
