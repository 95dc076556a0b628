// A spline as a function inside a pattern: it must outlive the text it was read from.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 right x*4/3 }
light_source { <-3, 5, -6> rgb 1 }
#declare S = spline { natural_spline 0, <0, 0>, 0.3, <1, 0>, 0.6, <0.2, 0>, 1, <0.9, 0> }
#declare F = function { spline { S } }
plane { -z, 0 pigment { function { F(x - floor(x)).x } color_map { [0 rgb 0] [1 rgb <1, 0.8, 0.3>] } } }
