// Triangles, flat and with smoothed normals.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 40 }
light_source { <-4, 6, -5> rgb 1 }
triangle { <-1.5, -0.7, 0>, <-0.2, -0.7, 0>, <-0.9, 0.9, 0.4> pigment { rgb <1, 0.6, 0.2> } }
smooth_triangle { <0.2, -0.7, 0>, <-0.5, -0.5, -1>, <1.6, -0.7, 0>, <0.6, -0.3, -1>, <0.9, 0.9, 0.4>, <0, 0.8, -0.6>
	pigment { rgb <0.3, 0.7, 1> } finish { phong 0.6 } }
