// assumed_gamma srgb: the srgb forms are taken as they are.
#version 3.7;
global_settings { assumed_gamma srgb }
#declare C = srgb <0.25, 0.5, 0.75>;
#debug concat(vstr(5, C, " ", 0, 5), "\n")
