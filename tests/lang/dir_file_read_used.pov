// A name that met the end of the file is defined, but has no value.
#version 3.7;
#fopen F "dir_file_read_empty.txt" read
#read (F, A)
#declare B = A + 1;
sphere { 0, 1 }
