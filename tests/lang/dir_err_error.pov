// #error stops the scene with its text.
#version 3.7;
#declare A = 5;
#error concat("A is ", str(A, 0, 0), "\n")
