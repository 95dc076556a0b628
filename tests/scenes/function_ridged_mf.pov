// f_ridged_mf uses the H and lacunarity of the first call: here that of the ground's normal, seen before
// its pigment and before the balls. The table of the second declaration is filled by the sky.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
#declare Other = function { internal(59) }
#declare Ridges = function(x, y, z, H, L) { f_ridged_mf(x, y, z, H, L, 7, 0.8, 0.9, 2) / 3 }
camera { location <0, 2, -5> look_at 0 right x*4/3 }
light_source { <5, 10, -8> rgb 1 }
plane { y, -1
	pigment { function { Ridges(x, y, z, 0.07, 2.2) } }
	normal { function { Ridges(x, y, z, 1.9, 3.1) } 0.5 }
}
sphere { <-1.2, 0, 0>, 1 pigment { function { f_ridged_mf(x, y, z, 0.3, 2.2, 8, 0.9, 0.9, 2) / 3 } } }
sphere { <1.2, 0, 0>, 1 pigment { function { Other(x, y, z, 0.2, 2.2, 6, 0.9, 0.9, 2) / 3 } } }
sky_sphere { pigment { function { Other(x, y, z, 1.2, 3.3, 6, 0.9, 0.9, 2) / 3 } scale 0.3 } }
