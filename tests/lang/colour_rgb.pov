// rgb takes three components; a float is a grey.
#version 3.7;
#declare C = rgb 0.5;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = rgb <1, 0.5, 0.25>;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
#declare C = rgb <1, 0.5>;
#debug concat(vstr(5, C, " ", 0, 4), "\n")
