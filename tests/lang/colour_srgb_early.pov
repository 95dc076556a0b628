// srgb before assumed_gamma has been said.
#version 3.7;
#declare C = srgb 0.5;
global_settings { assumed_gamma 1 }
