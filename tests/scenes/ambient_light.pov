// A coloured ambient light.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <1, 0.2, 0.5> }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { 0, 0.8 pigment { rgb 1 } finish { ambient 0.5 } }
