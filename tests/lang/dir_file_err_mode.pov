// A file is opened to read, write or append.
#version 3.7;
#fopen F "x.txt" update
