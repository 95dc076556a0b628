// Form of VTK without a surface: its camera and its lights.
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
light_source { <3.0, 4.0, 6.0> color <1.0, 0.9, 0.8>*0.9 spotlight radius 10.0 falloff 12.0 point_at <0, 0, 0> }
light_source { <-2.0, 1.0, 3.0> color <0.2, 0.3, 0.4>*1.0 parallel point_at <0, 0, 0> }
sphere { <-0.2, 0.0, 0.0>, 0.9 pigment { color rgb <0.8, 0.6, 0.3> } finish { ambient 0.1 diffuse 0.8 phong 0.4 phong_size 20 } }
box { <0.4, -0.9, -0.5>, <1.2, 0.1, 0.5> pigment { color rgb <0.3, 0.8, 0.4> } finish { ambient 0.1 diffuse 0.8 } }
