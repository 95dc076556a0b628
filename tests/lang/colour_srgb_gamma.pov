// With another working gamma srgb is decoded and encoded again.
#version 3.7;
global_settings { assumed_gamma 2.2 }
#declare C = srgb 0.5;
#debug concat(vstr(5, C, " ", 0, 5), "\n")
