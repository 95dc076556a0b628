// A wide angle and a location off the axis.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2, -3> look_at <0.5, 0, 0> right x * image_width / image_height angle 90 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
sphere { 0, 1 pigment { rgb <1, 0.6, 0.2> } }
sphere { <2, 0, 1>, 1 pigment { rgb <0.3, 0.7, 1> } }
