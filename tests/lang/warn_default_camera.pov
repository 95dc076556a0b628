// A default camera is a camera: no warning.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { camera { location -5*z } }
light_source { -5*z, 1 }
sphere { 0, 1 pigment { rgb 1 } }
