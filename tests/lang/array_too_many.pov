// An initialiser with too many elements.
#version 3.7;
#declare A = array[2] { 1, 2, 3 }
