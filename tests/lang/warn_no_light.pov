// No lamp, and a surface that needs one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }
box { 1, 2 pigment { rgb 1 } }
