// waits for: radiosity
// Form of OpenSCAD: polygons with a texture, a second finish and an interior; a camera with two `right`, an `up`, a sky and
// a rotation by the clock; photons without any target and a setting of rad_def.inc in a second global_settings at the end.
#version 3.7;
#include "colors.inc"
#include "rad_def.inc"
global_settings { assumed_gamma 2.0 }
background { color rgb <0.9, 0.9, 0.85> }
#declare Body = union {
 polygon { 5, <-1, 0, -1>, <1, 0, -1>, <1, 1.2, -1>, <-1, 1.2, -1>, <-1, 0, -1>
  texture { pigment { color rgb <0.98, 0.84, 0.17> } finish { phong 0.2 } }
  finish { ambient 0.12 diffuse 0.7 }
  interior { ior 1.32 }
 }
 polygon { 5, <1, 0, -1>, <1, 0, 1>, <1, 1.2, 1>, <1, 1.2, -1>, <1, 0, -1>
  texture { pigment { color rgbf <0.98, 0.84, 0.17, 0.2> } finish { phong 0.2 } }
  finish { ambient 0.12 diffuse 0.7 }
  interior { ior 1.32 }
 }
 polygon { 4, <-1, 1.2, -1>, <1, 1.2, -1>, <0, 1.6, 1>, <-1, 1.2, -1>
  texture { pigment { color rgb <0.3, 0.6, 0.3> } }
  finish { ambient 0.12 diffuse 0.7 }
 }
}
object { Body }
#for (X, -1, 1) #for (Y, -1, 1) #for (Z, -1, 1)
light_source { <X * 30, Y * 30 + 10, Z * 30> color rgb 1/15 }
#end #end #end
camera {
 location <2.2, 2.4, -5>
 right -x
 up y
 right x * image_width / image_height
 look_at <0, 0.6, 0>
 angle 36
 sky <0, 1, 0>
 rotate <0, clock * 360, 0>
}
global_settings {
 photons { count 20000 autostop 0 jitter 0 }
 radiosity { Rad_Settings(Radiosity_Fast, off, off) }
}
