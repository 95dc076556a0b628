// waits for: mesh2
// Form of FreeCAD: the camera by #declare, a sky_sphere, metals.inc, a light ten times as bright, bodies as mesh2.
#version 3.6;
#include "colors.inc"
#include "metals.inc"
#declare CamLocation = <3, 2, -5>;
#declare CamLookAt = <0, 0.2, 0>;
#declare Cam = camera { location CamLocation look_at CamLookAt angle 35 }
camera { Cam }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.2, 0.3, 0.6>] } } }
light_source { <20, 40, -30> color rgb <10, 10, 10> }
#declare Body = mesh2 {
 vertex_vectors { 8, <-1,0,-1>, <1,0,-1>, <1,0,1>, <-1,0,1>, <-1,1,-1>, <1,1,-1>, <1,1,1>, <-1,1,1> }
 face_indices { 12, <0,1,5>, <0,5,4>, <1,2,6>, <1,6,5>, <2,3,7>, <2,7,6>, <3,0,4>, <3,4,7>, <4,5,6>, <4,6,7>, <0,2,1>, <0,3,2> }
}
object { Body texture { pigment { rgb <0.8, 0.3, 0.2> } finish { F_MetalB } } }
plane { y, -0.01 texture { T_Brass_3B } }
