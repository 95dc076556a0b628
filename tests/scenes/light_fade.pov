// Light that fades with distance.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
light_source { <-1.5, 0.5, -0.5> rgb 2 fade_distance 1 fade_power 2 }
light_source { <1.5, 0.5, -0.5> rgb <0.5, 1, 2> fade_distance 0.6 fade_power 1 }
sphere { 0, 0.6 pigment { rgb 1 } finish { ambient 0 } }
