// Glass balls of several strengths, one hollow inside, before a checkered floor.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
#macro Ball(X, Ior) sphere { <X, 0, 0>, 0.55 pigment { rgbf <1, 1, 1, 0.9> } finish { specular 0.6 } interior { ior Ior } } #end
Ball(-1.2, 1) Ball(0, 1.33)
difference { sphere { 1.2 * x, 0.55 } sphere { 1.2 * x, 0.4 } pigment { rgbt <0.9, 1, 0.9, 0.9> } interior { ior 1.5 } }
