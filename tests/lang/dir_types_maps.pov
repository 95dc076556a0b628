// The types of maps, backgrounds of the sky and rainbows are declared, too.
#version 3.7;
#declare A = pigment_map { [0 rgb 0] [1 rgb 1] }
#declare B = normal_map { [0 bumps 1] }
#declare C = texture_map { [0 pigment { rgb 1 }] }
#declare D = slope_map { [0 <0, 1>] [1 <1, 0>] }
#declare E = density_map { [0 rgb 1] }
#declare F = sky_sphere { pigment { rgb 1 } }
#declare G = rainbow { direction z distance 10 color_map { [0 rgb 0] [1 rgb 1] } }
#declare H = union { sphere { 0, 1 } box { 0, 1 } }
#declare H2 = light_group { light_source { 0, 1 } }
#declare I = <1, 2, 3, 4>;
#debug concat(str(defined(A) + defined(B) + defined(C) + defined(D) + defined(E) + defined(F) +
	defined(G) + defined(H)
	+ defined(H2), 0, 0), str(I.t, 0, 0), "\n")
