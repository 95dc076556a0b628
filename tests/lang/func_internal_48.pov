// The built-in functions 48 to 59 at some points.
#version 3.7;
#declare F48 = function { internal(48) } // f_pillow
#debug concat("f_pillow ", str(F48(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F48(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F48(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F49 = function { internal(49) } // f_piriform
#debug concat("f_piriform ", str(F49(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F49(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F49(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F50 = function { internal(50) } // f_piriform_2d
#debug concat("f_piriform_2d ", str(F50(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45, 1, 0.4, 25), 0, 9),
	" ", str(F50(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45, 1, 0.4, 25), 0, 9), " ",
	str(F50(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45, 1, 0.4, 25), 0, 9), "\n")
#declare F51 = function { internal(51) } // f_poly4
#debug concat("f_poly4 ", str(F51(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45, 0.6), 0, 9),
	" ", str(F51(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45, 0.6), 0, 9), " ",
	str(F51(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45, 0.6), 0, 9), "\n")
#declare F52 = function { internal(52) } // f_polytubes
#debug concat("f_polytubes ", str(F52(0.3, 0.5, -0.7, 5, 0.4, 0.2, 0.1, 0.05, 0.02), 0, 9),
	" ", str(F52(-1.1, 0.2, 0.9, 5, 0.4, 0.2, 0.1, 0.05, 0.02), 0, 9), " ",
	str(F52(0, 0.4, 0, 5, 0.4, 0.2, 0.1, 0.05, 0.02), 0, 9), "\n")
#declare F53 = function { internal(53) } // f_quantum
#debug concat("f_quantum ", str(F53(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F53(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F53(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F54 = function { internal(54) } // f_quartic_paraboloid
#debug concat("f_quartic_paraboloid ", str(F54(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F54(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F54(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F55 = function { internal(55) } // f_quartic_saddle
#debug concat("f_quartic_saddle ", str(F55(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F55(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F55(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F56 = function { internal(56) } // f_quartic_cylinder
#debug concat("f_quartic_cylinder ", str(F56(0.3, 0.5, -0.7, 1.3, 0.7, 0.9), 0, 9),
	" ", str(F56(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9), 0, 9), " ",
	str(F56(0, 0.4, 0, 1.3, 0.7, 0.9), 0, 9), "\n")
#declare F57 = function { internal(57) } // f_r
#debug concat("f_r ", str(F57(0.3, 0.5, -0.7), 0, 9),
	" ", str(F57(-1.1, 0.2, 0.9), 0, 9), " ", str(F57(0, 0.4, 0), 0, 9), "\n")
#declare F58 = function { internal(58) } // f_ridge
#debug concat("f_ridge ", str(F58(0.3, 0.5, -0.7, 2.1, 4.5, 0.6, 0.4, 0.5, 3), 0, 9),
	" ", str(F58(-1.1, 0.2, 0.9, 2.1, 4.5, 0.6, 0.4, 0.5, 3), 0, 9), " ",
	str(F58(0, 0.4, 0, 2.1, 4.5, 0.6, 0.4, 0.5, 3), 0, 9), "\n")
#declare F59 = function { internal(59) } // f_ridged_mf
#debug concat("f_ridged_mf ", str(F59(0.3, 0.5, -0.7, 0.8, 2.2, 6, 0.7, 1.5, 2), 0, 9),
	" ", str(F59(-1.1, 0.2, 0.9, 0.8, 2.2, 6, 0.7, 1.5, 2), 0, 9), " ",
	str(F59(0, 0.4, 0, 0.8, 2.2, 6, 0.7, 1.5, 2), 0, 9), "\n")
