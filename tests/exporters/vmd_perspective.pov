// Form of VMD, its perspective camera: direction after look_at and a sky that turns it.
#if (version < 3.5)
#error "this scene needs a newer version"
#end
#default { texture { finish { ambient 0.0 diffuse 0.85 phong 0.1 } } }
camera {
  up <0, 1.0000, 0>
  right <1.3333, 0, 0>
  location <0.0000, 0.0000, -3.0000>
  look_at <0.0000, 0.0000, 2.0000>
  direction <0.0000, 0.0000, 1.5000>
  sky <0,-1,0>
}
light_source { <-1.5, 2.0, -3.0> color rgb<1.000, 1.000, 1.000> parallel point_at <0.0, 0.0, 0.0> }
background { color rgb<0.3, 0.2, 0.4> }
sphere { <0.3, 0.4, 0>, 0.6 texture { pigment { rgbt<0.9, 0.4, 0.1, 0.0> } } }
cone { <-0.8, -0.7, 0>, 0.4 <-0.5, 0.5, 0>, 0.0 open texture { pigment { rgbt<0.1, 0.6, 0.6, 0.0> } } }
