// rgb of a colour stores all its five components, with a warning.
#version 3.7;
#declare G = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;
#declare C = rgb G;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = rgb <1, 2, 3, 4>;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = rgbt G;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
