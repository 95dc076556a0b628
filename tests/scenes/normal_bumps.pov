// Bumps, small and large, with turbulence.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { -x, 0.8 pigment { rgb <1, 0.6, 0.2> } normal { bumps 0.6 scale 0.15 } finish { phong 0.5 } }
sphere { x, 0.8 pigment { rgb <0.3, 0.7, 1> } normal { bumps 1.2 turbulence 0.4 scale <0.1, 0.3, 0.1> } finish { specular 0.5 } }
