// Accepted with a warning: orient without circular, roughness 0.
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <2,6,-2>, 1 area_light 2*x, 2*z, 9, 9 orient }
sphere { 0, 1 finish { specular 0.4 roughness 0 } }
camera { location -5*z look_at 0 }
