// A file to read must exist.
#version 3.7;
#fopen F "dir_file_err_missing.txt" read
