// A semicolon between statements is an error.
#version 3.7;
sphere { 0, 1 };
