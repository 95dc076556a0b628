// Cones: to a point, cut off, open, and one that is a cylinder.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
cone { <-1.3, -0.7, 0>, 0.5, <-1.3, 0.8, 0>, 0 pigment { rgb <1, 0.6, 0.2> } }
cone { <-0.2, 0.7, 0>, 0.5, <-0.2, -0.7, 0>, 0.2 pigment { rgb <0.3, 0.7, 1> } }
cone { <0.7, -0.5, 0>, 0.2, <0.7, 0.5, 0>, 0.4 open rotate x * -20 pigment { rgb <0.7, 0.9, 0.4> } }
cone { <1.5, -0.5, 0>, 0.2, <1.5, 0.5, 0>, 0.2 pigment { rgb 0.8 } }
