// Coloured glass that darkens with depth.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
box { <-1.5, -0.8, 0>, <-0.3, 0.8, 0.4> pigment { rgbf 1 } interior { ior 1.1 fade_distance 0.3 fade_power 1 } }
sphere { 0.8 * x, 0.8 pigment { rgbt 1 } interior { fade_distance 0.5 fade_power 1001 fade_color rgb <0.9, 0.3, 0.2> } }
