// The default camera stands at the origin.
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { -5*z, 1 }
sphere { 5*z, 1 pigment { rgb 1 } }
