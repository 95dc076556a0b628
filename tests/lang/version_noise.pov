// Below 3.5 the noise generator is 1 unless said otherwise.
#version 3.1;
#version 3.7;
#declare F = function { internal(76) }
#debug concat(str(F(1.5, 2.25, -3.125), 0, 9), "\n")
#version 3.1;
#debug concat(vstr(3, vturbulence(2, 0.5, 6, <1.5, 2.5, 3.5>), " ", 0, 6), "\n")
#debug concat(str(F(1.5, 2.25, -3.125), 0, 9), "\n")
