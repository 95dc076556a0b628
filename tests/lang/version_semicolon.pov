// From 3.5 on a declared expression ends with a semicolon.
#version 3.7;
#declare A = 5
#declare B = 6;
