// The built-in functions 24 to 35 at some points.
#version 3.7;
#declare F24 = function { internal(24) } // f_helical_torus
#debug concat("f_helical_torus ",
	str(F24(0.3, 0.5, -0.7, 1, 3, 2, 0.2, 0.3, 0.4, 0.5, 2, 1.5, 0.3), 0, 9),
	" ", str(F24(-1.1, 0.2, 0.9, 1, 3, 2, 0.2, 0.3, 0.4, 0.5, 2, 1.5, 0.3), 0, 9), " ",
	str(F24(0, 0.4, 0, 1, 3, 2, 0.2, 0.3, 0.4, 0.5, 2, 1.5, 0.3), 0, 9), "\n")
#declare F25 = function { internal(25) } // f_helix1
#debug concat("f_helix1 ", str(F25(0.3, 0.5, -0.7, 2, 1.5, 0.2, 0.6, 1.1, 0.7, 20), 0, 9),
	" ", str(F25(-1.1, 0.2, 0.9, 2, 1.5, 0.2, 0.6, 1.1, 0.7, 20), 0, 9), " ",
	str(F25(0, 0.4, 0, 2, 1.5, 0.2, 0.6, 1.1, 0.7, 20), 0, 9), "\n")
#declare F26 = function { internal(26) } // f_helix2
#debug concat("f_helix2 ", str(F26(0.3, 0.5, -0.7, 1, 3, 0.25, 0.6, 1, 0.7, 0), 0, 9),
	" ", str(F26(-1.1, 0.2, 0.9, 1, 3, 0.25, 0.6, 1, 0.7, 0), 0, 9), " ",
	str(F26(0, 0.4, 0, 1, 3, 0.25, 0.6, 1, 0.7, 0), 0, 9), "\n")
#declare F27 = function { internal(27) } // f_hex_x
#debug concat("f_hex_x ", str(F27(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F27(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F27(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F28 = function { internal(28) } // f_hex_y
#debug concat("f_hex_y ", str(F28(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F28(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F28(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F29 = function { internal(29) } // f_hetero_mf
#debug concat("f_hetero_mf ", str(F29(0.3, 0.5, -0.7, 0.9, 2.1, 5.5, 0.6, 2, 3), 0, 9),
	" ", str(F29(-1.1, 0.2, 0.9, 0.9, 2.1, 5.5, 0.6, 2, 3), 0, 9), " ",
	str(F29(0, 0.4, 0, 0.9, 2.1, 5.5, 0.6, 2, 3), 0, 9), "\n")
#declare F30 = function { internal(30) } // f_hunt_surface
#debug concat("f_hunt_surface ", str(F30(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F30(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F30(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F31 = function { internal(31) } // f_hyperbolic_torus
#debug concat("f_hyperbolic_torus ", str(F31(0.3, 0.5, -0.7, 1.3, 0.7, 0.9), 0, 9),
	" ", str(F31(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9), 0, 9), " ",
	str(F31(0, 0.4, 0, 1.3, 0.7, 0.9), 0, 9), "\n")
#declare F32 = function { internal(32) } // f_isect_ellipsoids
#debug concat("f_isect_ellipsoids ", str(F32(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45), 0, 9),
	" ", str(F32(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45), 0, 9), " ",
	str(F32(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45), 0, 9), "\n")
#declare F33 = function { internal(33) } // f_kampyle_of_eudoxus
#debug concat("f_kampyle_of_eudoxus ", str(F33(0.3, 0.5, -0.7, 1.3, 0.7, 0.9), 0, 9),
	" ", str(F33(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9), 0, 9), " ",
	str(F33(0, 0.4, 0, 1.3, 0.7, 0.9), 0, 9), "\n")
#declare F34 = function { internal(34) } // f_kampyle_of_eudoxus_2d
#debug concat("f_kampyle_of_eudoxus_2d ",
	str(F34(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9),
	" ", str(F34(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), " ",
	str(F34(0, 0.4, 0, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), "\n")
#declare F35 = function { internal(35) } // f_klein_bottle
#debug concat("f_klein_bottle ", str(F35(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F35(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F35(0, 0.4, 0, 1.3), 0, 9), "\n")
