// rgbft takes all five; a float fills them.
#version 3.7;
#declare C = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = rgbft 0.25;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
