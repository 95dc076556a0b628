// waits for: mesh2
// Form of VTK: ambient_light with `color rgb`, assumed_gamma 2, sky and a mirrored right, a spotlight whose falloff is its
// exponent, a mesh2 with commas at the ends of its lists and without normal_indices.
global_settings { ambient_light color rgb <1.0, 1.0, 1.0> assumed_gamma 2 }
background { color rgb <0.10, 0.20, 0.40> }
camera {
 perspective
 location <2.0, 1.5, 6.0>
 sky <0.0, 1.0, 0.0>
 right <-1, 0, 0>
 angle 30.0
 look_at <0.0, 0.0, 0.0>
}
light_source { <3.0, 4.0, 6.0> color <1.0, 0.9, 0.8>*0.9 spotlight radius 30.0 falloff 40.0 point_at <0, 0, 0> }
mesh2 {
 vertex_vectors { 4,
  <-1.0, -0.8, 0.0>, <1.0, -0.8, 0.2>, <0.9, 0.9, 0.0>, <-0.8, 0.8, 0.4>, }
 normal_vectors { 4,
  <-0.2, 0.0, 1.0>, <0.2, 0.0, 1.0>, <0.2, 0.2, 1.0>, <-0.1, 0.2, 1.0>, }
 face_indices { 2,
  <0, 1, 2>, <0, 2, 3>, }
 pigment { color rgb <0.8, 0.6, 0.3> }
 finish { ambient 0.1 diffuse 0.8 phong 0.4 phong_size 20 }
}
