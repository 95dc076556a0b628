// The srgb forms are decoded, within and beyond 0 to 1; filter and transmit are not.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare C = srgb <0.5, 1.5, -0.5>;
#debug concat(vstr(5, C, " ", 0, 5), "\n")
#declare C = srgbf <0.02, 0.2, 1, 0.5>;
#debug concat(vstr(5, C, " ", 0, 5), "\n")
#declare C = srgbt <0.02, 0.2, 1, 0.5>;
#debug concat(vstr(5, C, " ", 0, 5), "\n")
#declare C = srgbft 0.5;
#debug concat(vstr(5, C, " ", 0, 5), "\n")
