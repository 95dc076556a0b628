// Colours worked out in sRGB, and srgb colours.
#version 3.7;
global_settings { assumed_gamma srgb }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
sphere { -0.9 * x, 0.8 pigment { rgb <0.5, 0.25, 0.75> } }
sphere { 0.9 * x, 0.8 pigment { srgb <0.5, 0.25, 0.75> } }
