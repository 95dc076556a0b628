// vturbulence with the noise generator in force.
#version 3.7;
#debug concat(vstr(3, vturbulence(2, 0.5, 6, <1.5, 2.5, 3.5>), ",", 0, 6), "\n")
#debug concat(vstr(3, vturbulence(2.2, 0.4, 3.9, <-1, 2, 0.5>), ",", 0, 6), "\n")
