// An orthographic camera whose view follows from angle.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 2, -5> look_at 0 angle 35 }
light_source { <-4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.5> } }
sphere { 0, 0.8 pigment { rgb <1, 0.6, 0.2> } }
