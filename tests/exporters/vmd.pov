// Form of VMD: a guard on the version, an array some of whose elements are never set, macros whose arguments have no
// commas between them, #if inside an object, `open` after the radius, the triangle of three colours, clip planes,
// parallel lights, a camera with direction after look_at.
#if (version < 3.5)
#error "this scene needs a newer version"
#end
#declare CLIP=array[3];
#declare CLIP[1]=plane { <0.8, 0.1, 0.2>, 1.1 texture { pigment { rgbt <1, 1, 1, 1> } } };
#declare CLIP[2]=plane { <0.3, 0.9, -0.2>, -1.2 };
#default { texture {
 finish { ambient 0.000 diffuse 0.650 phong 0.1 phong_size 40.000 specular 0.500 }
} }
#declare cylinders_open=0;
#macro ball (P, R, C)
  sphere { P, R texture { pigment { C } } }
#end
#macro rod (A B R C O)
  cylinder { A, B, R
    #if (O) open #end
    texture { pigment { C } }
    #if (cylinders_open = 0) no_shadow #end
  }
#end
#macro tricolour (V1 V2 V3 N1 N2 N3 C1 C2 C3)
  #local E1 = V2 - V1;
  #local E2 = V3 - V1;
  #local M = vcross(E1, E2);
  smooth_triangle { V1, N1, V2, N2, V3, N3
    texture { pigment {
      average pigment_map {
        [1 gradient x color_map { [0 rgb 0] [1 rgb 3*C2] }]
        [1 gradient y color_map { [0 rgb 0] [1 rgb 3*C3] }]
        [1 gradient z color_map { [0 rgb 0] [1 rgb 3*C1] }]
      }
      matrix <1.01, 0, 1, 0, 1.01, 1, 0, 0, 1, -0.002, -0.002, -1>
      matrix <E1.x, E1.y, E1.z, E2.x, E2.y, E2.z, M.x, M.y, M.z, V1.x, V1.y, V1.z>
    } }
  }
#end
camera {
  up <0, 3.0000, 0>
  right <4.0000, 0, 0>
  location <0.0000, 0.0000, -2.0000>
  look_at <0.0000, 0.0000, 2.0000>
  direction <0.0000, 0.0000, 2.0000>
}
light_source { <-0.1000, 0.1000, -1.0000> color rgb<1.000, 1.000, 1.000> parallel point_at <0.0, 0.0, 0.0> }
light_source { <1.0000, 2.0000, -0.5000> color rgb<1.000, 1.000, 1.000> parallel point_at <0.0, 0.0, 0.0> }
background { color rgb<0.100, 0.100, 0.150> }
fog { distance 9.0 fog_type 1 color rgb<0.100, 0.100, 0.150> }
ball(<-0.9, 0.5, 0.3>, 0.6, rgbt<0.2, 0.3, 0.9, 0.0>)
rod(<-0.9, 0.5, 0.3> <0.7, -0.6, 0.0> 0.15 rgbt<0.4 0.8 0.3 0.0> 1)
tricolour(<-0.4, -1.1, 0.4> <1.3, -0.8, 0.6> <0.5, 1.0, 0.8> <-0.2, 0.0, -1> <0.3, 0.1, -1> <0.0, 0.2, -1> <1 0 0> <0 1 0> <0 0 1>)
sphere { <-1.4, -0.9, 0.2>, 0.5
  texture { pigment { rgbt <0.9, 0.4, 0.6, 0.0> } }
  clipped_by { CLIP[2] }
}
intersection {
  sphere { <1.0, 0.5, 0.0>, 0.5 texture { pigment { rgbt <0.9, 0.8, 0.2, 0.0> } } }
  object { CLIP[1] }
}
