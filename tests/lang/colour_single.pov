// Declared colours are kept in single precision.
#version 3.7;
#declare C = rgb <0.1, 1/3, 0.7>;
#debug concat(vstr(3, C, " ", 0, 12), "\n")
#declare V = <0.1, 1/3, 0.7>;
#debug concat(vstr(3, V, " ", 0, 12), "\n")
