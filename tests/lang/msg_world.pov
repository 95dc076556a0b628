// Errors and warnings of cameras, lights, the atmosphere and settings, one after the other.
#version 3.7;
global_settings { assumed_gamma 1 }
global_settings { assumed_gamma 2 }
camera { angle 180 }
camera { angle -1 }
camera { location 1 look_at 1 }
light_source { 0, 1 radius 5 }
light_source { 0, 1 point_at 5 }
light_source { 0, 1 area_light x, y, 0, 2 }
light_source { 0, 1 circular }
light_source { 0, 1 orient area_light x, y, 3, 3 }
light_source { 0, 1 area_illumination on orient circular area_light x, y, 2, 2 }
light_source { 0, 1 area_illumination on }
light_source { 0, rgbf 1 }
fog { distance 1 rgb 1 fog_type 5 }
sky_sphere { pigment { rgb 1 } }
sky_sphere { pigment { rgb 0 } }
sky_sphere { }
max_trace_level 5
max_intersections 5
global_settings { max_intersections 5 }
global_settings { hf_gray_16 }
global_settings { max_trace_level 999 }
global_settings { number_of_waves 0 }
sphere { 0, 1 }
