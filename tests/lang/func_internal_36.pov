// The built-in functions 36 to 47 at some points.
#version 3.7;
#declare F36 = function { internal(36) } // f_kummer_surface_v1
#debug concat("f_kummer_surface_v1 ", str(F36(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F36(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F36(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F37 = function { internal(37) } // f_kummer_surface_v2
#debug concat("f_kummer_surface_v2 ", str(F37(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45), 0, 9),
	" ", str(F37(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45), 0, 9), " ",
	str(F37(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45), 0, 9), "\n")
#declare F38 = function { internal(38) } // f_lemniscate_of_gerono
#debug concat("f_lemniscate_of_gerono ", str(F38(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F38(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F38(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F39 = function { internal(39) } // f_lemniscate_of_gerono_2d
#debug concat("f_lemniscate_of_gerono_2d ",
	str(F39(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9),
	" ", str(F39(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), " ",
	str(F39(0, 0.4, 0, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), "\n")
#declare F40 = function { internal(40) } // f_mesh1
#debug concat("f_mesh1 ", str(F40(0.3, 0.5, -0.7, 1, 1.3, 0.2, 0.1, 1.1), 0, 9),
	" ", str(F40(-1.1, 0.2, 0.9, 1, 1.3, 0.2, 0.1, 1.1), 0, 9), " ",
	str(F40(0, 0.4, 0, 1, 1.3, 0.2, 0.1, 1.1), 0, 9), "\n")
#declare F41 = function { internal(41) } // f_mitre
#debug concat("f_mitre ", str(F41(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F41(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F41(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F42 = function { internal(42) } // f_nodal_cubic
#debug concat("f_nodal_cubic ", str(F42(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F42(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F42(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F43 = function { internal(43) } // f_odd
#debug concat("f_odd ", str(F43(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F43(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F43(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F44 = function { internal(44) } // f_ovals_of_cassini
#debug concat("f_ovals_of_cassini ", str(F44(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45), 0, 9),
	" ", str(F44(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45), 0, 9), " ",
	str(F44(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45), 0, 9), "\n")
#declare F45 = function { internal(45) } // f_paraboloid
#debug concat("f_paraboloid ", str(F45(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F45(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F45(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F46 = function { internal(46) } // f_parabolic_torus
#debug concat("f_parabolic_torus ", str(F46(0.3, 0.5, -0.7, 1.3, 0.7, 0.9), 0, 9),
	" ", str(F46(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9), 0, 9), " ",
	str(F46(0, 0.4, 0, 1.3, 0.7, 0.9), 0, 9), "\n")
#declare F47 = function { internal(47) } // f_ph
#debug concat("f_ph ", str(F47(0.3, 0.5, -0.7), 0, 9),
	" ", str(F47(-1.1, 0.2, 0.9), 0, 9), " ", str(F47(0, 0.4, 0), 0, 9), "\n")
