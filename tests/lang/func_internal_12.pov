// The built-in functions 12 to 23 at some points.
#version 3.7;
#declare F12 = function { internal(12) } // f_cubic_saddle
#debug concat("f_cubic_saddle ", str(F12(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F12(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F12(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F13 = function { internal(13) } // f_cushion
#debug concat("f_cushion ", str(F13(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F13(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F13(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F14 = function { internal(14) } // f_devils_curve
#debug concat("f_devils_curve ", str(F14(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F14(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F14(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F15 = function { internal(15) } // f_devils_curve_2d
#debug concat("f_devils_curve_2d ", str(F15(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9),
	" ", str(F15(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), " ",
	str(F15(0, 0.4, 0, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), "\n")
#declare F16 = function { internal(16) } // f_dupin_cyclid
#debug concat("f_dupin_cyclid ", str(F16(0.3, 0.5, -0.7, 1.1, 0.5, 0.3, 0.8, 0.9, 0.4), 0, 9),
	" ", str(F16(-1.1, 0.2, 0.9, 1.1, 0.5, 0.3, 0.8, 0.9, 0.4), 0, 9), " ",
	str(F16(0, 0.4, 0, 1.1, 0.5, 0.3, 0.8, 0.9, 0.4), 0, 9), "\n")
#declare F17 = function { internal(17) } // f_ellipsoid
#debug concat("f_ellipsoid ", str(F17(0.3, 0.5, -0.7, 1.3, 0.7, 0.9), 0, 9),
	" ", str(F17(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9), 0, 9), " ",
	str(F17(0, 0.4, 0, 1.3, 0.7, 0.9), 0, 9), "\n")
#declare F18 = function { internal(18) } // f_enneper
#debug concat("f_enneper ", str(F18(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F18(-1.1, 0.2, 0.1, 1.3), 0, 9), "\n")
#declare F19 = function { internal(19) } // f_flange_cover
#debug concat("f_flange_cover ", str(F19(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45), 0, 9),
	" ", str(F19(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45), 0, 9), " ",
	str(F19(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45), 0, 9), "\n")
#declare F20 = function { internal(20) } // f_folium_surface
#debug concat("f_folium_surface ", str(F20(0.3, 0.5, -0.7, 1.3, 0.7, 0.9), 0, 9),
	" ", str(F20(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9), 0, 9), " ",
	str(F20(0, 0.4, 0, 1.3, 0.7, 0.9), 0, 9), "\n")
#declare F21 = function { internal(21) } // f_folium_surface_2d
#debug concat("f_folium_surface_2d ", str(F21(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9),
	" ", str(F21(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), " ",
	str(F21(0, 0.4, 0, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), "\n")
#declare F22 = function { internal(22) } // f_glob
#debug concat("f_glob ", str(F22(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F22(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F22(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F23 = function { internal(23) } // f_heart
#debug concat("f_heart ", str(F23(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F23(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F23(0, 0.4, 0, 1.3), 0, 9), "\n")
