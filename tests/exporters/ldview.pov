// waits for: mesh, mesh2
// Form of LDView: braces opened and closed inside different #if, `material` or `texture` by version, #version changed and
// set back, `right A * <-1,0,0>`, a transform in the camera, parts as mesh and mesh2.
#declare AR = image_width / image_height;
#declare QUAL = 2;
#declare SW = 0.5;
#declare IPOV = version;
#version 3.5;
#macro plate(W, D)
 box { <0, 0, 0>, <W, 0.3, D> }
#end
#version IPOV;
#if (QUAL > 1)
union {
#end
 object { plate(2, 1)
 #if (version >= 3.1) material { #end
  texture { pigment { rgb <0.7, 0.1, 0.1> } finish { ambient 0.3 diffuse 0.6 phong 0.4 } }
 #if (version >= 3.1) interior { ior 1.2 } } #end
 }
 cylinder { <0.5, 0.3, 0.5>, <0.5, 0.5, 0.5>, 0.3
 #if (version >= 3.1) material { #end
  texture { pigment { rgbf <0.2, 0.6, 0.9, 0.4> } finish { ambient 0.3 diffuse 0.6 } }
 #if (version >= 3.1) interior { ior 1.2 } } #end
 }
#if (QUAL > 1)
}
#else
#end
#declare Turn = transform { rotate <-20, 30, 0> translate <1.2, 0.5, 0.5> }
camera {
 #declare PCT = 0;
 #declare STEREO = 0;
 location <STEREO, 0, -5>
 sky y
 up y
 right AR * <-1, 0, 0>
 look_at <0, 0, 0>
 angle 40
 transform { Turn }
}
light_source { <-4, 8, -6> color rgb <1, 1, 1> }
background { color rgb <0.85, 0.9, 0.8> }
mesh { triangle { <0, 0, 1>, <2, 0, 1>, <1, 1.2, 1.4> } pigment { rgb <0.9, 0.8, 0.1> } }
mesh2 {
 vertex_vectors { 3, <1.2, 0.3, 0.2>, <1.8, 0.3, 0.2>, <1.5, 0.9, 0.5> }
 face_indices { 1, <0, 1, 2> }
 pigment { rgb <0.1, 0.7, 0.2> }
}
