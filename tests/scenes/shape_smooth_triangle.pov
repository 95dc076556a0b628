// scale keeps the weights of the normals of a smooth_triangle, a matrix does not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z right 8*x up 6*y look_at 0 }
light_source { <-30, 40, -50> rgb 1 }
#declare T = smooth_triangle {
	<-1.2, -1, 0>, <-0.8, -0.5, -1>, <1.2, -1, 0>, <0.9, -0.2, -0.5>, <0, 1.2, 0>, <0, 0.8, -1>
	pigment { rgb 0.9 } finish { ambient 0.1 phong 0.8 }
}
object { T scale <1, 1, 4> translate <-2, 1.4, 0> }
object { T matrix <1, 0, 0, 0, 1, 0, 0, 0, 4, 0, 0, 0> translate <2, 1.4, 0> }
object { T rotate 20*y transform { scale <1.3, 1, 0.2> } translate <-2, -1.4, 0> }
object { T matrix <1, 0.3, 0, 0.2, 1, 0, 1, 0, 0.5, 0, 0, 0> scale <1, 1, 3> translate <2, -1.4, 0> }
