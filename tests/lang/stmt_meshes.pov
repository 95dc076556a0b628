// mesh and mesh2 with textures, uv vectors and an inside.
#version 3.7;
#declare T = texture { pigment { rgb x } }
#declare U = texture { pigment { rgb y } }
#declare M = mesh { triangle { 0, x, y texture { T } } triangle { 0, x, z uv_vectors <0, 0>, <1, 0>, <0, 1> }
	smooth_triangle { 0, z, x, z, y, z texture_list { T, U, T } } inside_vector y hierarchy on }
#declare N = mesh2 { vertex_vectors { 4, 0, x, y, z } normal_vectors { 1, y } uv_vectors { 1, <0, 0> }
	texture_list { 2, texture { T }, texture { U } }
	face_indices { 2, <0, 1, 2>, 0, <0, 1, 3>, 0, 1, 1 } uv_indices { 2, <0, 0, 0>, <0, 0, 0> }
	normal_indices { 2, <0, 0, 0>, <0, 0, 0> } inside_vector <0, 0, 1> }
#declare O = mesh2 { vertex_vectors { 3 0 x y } face_indices { 1 <0, 1, 2> } }
#debug "ok\n"
