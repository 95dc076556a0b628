// Words may follow rgb or an identifier and replace single components.
#version 3.7;
#declare Red = rgb x;
#declare C = color Red filter 0.5;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = rgb <1, 1, 0> transmit 0.25 red 0.5;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
