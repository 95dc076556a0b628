// Parallel rays; the size of the view comes from right and up.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 4, -5> right 4 * x up 3 * y look_at 0 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
box { -0.5, 0.5 rotate y * 45 pigment { rgb <1, 0.6, 0.2> } }
box { <1, -0.5, 2>, <2, 0.5, 3> rotate y * 45 pigment { rgb <0.3, 0.7, 1> } }
