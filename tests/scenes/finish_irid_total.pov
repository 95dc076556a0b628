// Light reflected totally within glass is tinted by irid, as a reflection is.
#version 3.7; global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0,3,-6> look_at 0 right 4/3*x angle 40 }
sky_sphere { pigment { gradient y color_map { [0 rgb .2] [1 rgb 1] } } }
box { -1, 1 rotate 30*y pigment { rgbf 1 } finish { ambient 0 diffuse 0 irid { .6 thickness .8 turbulence 0 } } interior { ior 1.5 } }
