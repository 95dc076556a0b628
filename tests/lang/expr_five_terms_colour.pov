// A vector of five terms becomes a colour, in single precision.
#version 3.7;
#declare C = <0.1, 0.2, 0.3, 0.4, 0.5>;
#declare V = <0.1, 0.2, 0.3, 0.4>;
#debug concat(str(C.red, 0, 12), " ", str(C.filter, 0, 12), " ", str(V.x, 0, 12), "\n")
