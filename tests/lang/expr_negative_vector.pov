// The sign of a vector holds for all its components, of a colour for filter and transmit, too.
#version 3.7;
#declare C = rgbft <1, 2, 3, 4, 5>;
#debug concat(vstr(3, -<1, -2, 3>, ",", 0, 0), " ", vstr(5, -C, ",", 0, 0), "\n")
