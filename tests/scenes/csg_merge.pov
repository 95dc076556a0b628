// Glassy union and merge: a merge has no inner walls.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
#declare Glass = texture { pigment { rgbf <0.9, 1, 0.9, 0.8> } finish { reflection 0.1 specular 0.5 } }
union { sphere { -0.3 * x, 0.6 } sphere { 0.3 * x, 0.6 } translate -0.9 * x texture { Glass } interior { ior 1.2 } }
merge { sphere { -0.3 * x, 0.6 } sphere { 0.3 * x, 0.6 } translate 0.9 * x texture { Glass } interior { ior 1.2 } }
