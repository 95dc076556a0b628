// switches: +W80 +H60 -A +Q4
// Quality 4: shadows, but neither reflection nor refraction.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
sphere { -0.8 * x, 0.6 pigment { rgb <1, 0.6, 0.2> } finish { reflection 0.6 } }
sphere { 0.8 * x, 0.6 pigment { rgbf <0.5, 1, 1, 0.8> } interior { ior 1.5 } }
