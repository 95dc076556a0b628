// Form of FreeCAD without bodies: its template of camera, sky and light.
#version 3.6;
#include "colors.inc"
#include "metals.inc"
#declare CamLocation = <3, 2, -5>;
#declare CamLookAt = <0, 0.2, 0>;
#declare Cam = camera { location CamLocation look_at CamLookAt angle 35 }
camera { Cam }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.2, 0.3, 0.6>] } } }
light_source { <20, 40, -30> color rgb <10, 10, 10> }
plane { y, 0 texture { T_Brass_3B } }
sphere { <0, 0.7, 0>, 0.7 texture { pigment { rgb <0.1, 0.05, 0.2> } finish { F_MetalB } } }
