// POV-Ray stops for want of memory.
#version 3.7;
camera { location -5*z look_at 0 }
light_source { <2, 4, -3> rgb 1 area_light x, y, 100000, 100000 adaptive 1 }
sphere { 0, 1 }
