// Reflection: constant, coloured, varying with the angle, metallic, with exponent.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
#macro Ball(X, Y) sphere { <X, Y, 0>, 0.48 pigment { rgb <0.6, 0.4, 0.2> } #end
Ball(-1, 0.5) finish { reflection 0.5 } }
Ball(0, 0.5) finish { reflection rgb <0.2, 0.5, 0.8> } }
Ball(1, 0.5) finish { reflection { 0.1, 0.9 falloff 3 } } }
Ball(-1, -0.5) finish { reflection { 0.6 metallic } } }
Ball(0, -0.5) finish { reflection { 0.8 exponent 0.5 } } }
Ball(1, -0.5) finish { reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.5 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.9, 1>] [1 rgb <0.2, 0.4, 0.8>] } } }
