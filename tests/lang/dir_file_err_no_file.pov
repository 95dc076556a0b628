// #read wants an open file.
#version 3.7;
#read (F, A)
