// What is declared must be a name.
#version 3.7;
#declare 5 = 5;
