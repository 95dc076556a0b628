// rgbt takes red, green, blue, transmit; a float fills those four.
#version 3.7;
#declare C = rgbt <0.1, 0.2, 0.3, 0.4>;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = rgbt 0.5;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = rgbt <0.1, 0.2>;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
