// The noise functions: by number, with each generator, and by the one in force.
#version 3.7;
#include "functions.inc"
#declare V = <1.5, 2.25, -3.125>;
#debug concat(str(f_noise3d(1.5, 2.25, -3.125), 0, 9), " ",
	str(f_snoise3d(1.5, 2.25, -3.125), 0, 9), "\n")
#for (G, 1, 3) #debug concat(str(f_noise_generator(1.5, 2.25, -3.125, G), 0, 9), " ") #end
#debug "\n"
global_settings { noise_generator 1 }
#debug concat(str(f_noise3d(1.5, 2.25, -3.125), 0, 9), "\n")
#debug concat(vstr(3, vturbulence(2, 0.5, 6, V), " ", 0, 6), "\n")
