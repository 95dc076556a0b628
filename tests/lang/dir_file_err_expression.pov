// A datum is a literal, not an expression or identifier.
#version 3.7;
#declare B = 5;
#fopen F "dir_file_err_expression.txt" read
#read (F, A)
