// The built-in functions 0 to 11 at some points.
#version 3.7;
#declare F0 = function { internal(0) } // f_algbr_cyl1
#debug concat("f_algbr_cyl1 ", str(F0(0.3, 0.5, -0.7, 1.3, 9, 1, 0.45, 25), 0, 9),
	" ", str(F0(-1.1, 0.2, 0.9, 1.3, 9, 1, 0.45, 25), 0, 9), " ",
	str(F0(0, 0.4, 0, 1.3, 9, 1, 0.45, 25), 0, 9), "\n")
#declare F1 = function { internal(1) } // f_algbr_cyl2
#debug concat("f_algbr_cyl2 ", str(F1(0.3, 0.5, -0.7, 1.3, 9, 1, 0.45, 25), 0, 9),
	" ", str(F1(-1.1, 0.2, 0.9, 1.3, 9, 1, 0.45, 25), 0, 9), " ",
	str(F1(0, 0.4, 0, 1.3, 9, 1, 0.45, 25), 0, 9), "\n")
#declare F2 = function { internal(2) } // f_algbr_cyl3
#debug concat("f_algbr_cyl3 ", str(F2(0.3, 0.5, -0.7, 1.3, 9, 1, 0.45, 25), 0, 9),
	" ", str(F2(-1.1, 0.2, 0.9, 1.3, 9, 1, 0.45, 25), 0, 9), " ",
	str(F2(0, 0.4, 0, 1.3, 9, 1, 0.45, 25), 0, 9), "\n")
#declare F3 = function { internal(3) } // f_algbr_cyl4
#debug concat("f_algbr_cyl4 ", str(F3(0.3, 0.5, -0.7, 1.3, 9, 1, 0.45, 25), 0, 9),
	" ", str(F3(-1.1, 0.2, 0.9, 1.3, 9, 1, 0.45, 25), 0, 9), " ",
	str(F3(0, 0.4, 0, 1.3, 9, 1, 0.45, 25), 0, 9), "\n")
#declare F4 = function { internal(4) } // f_bicorn
#debug concat("f_bicorn ", str(F4(0.3, 0.5, -0.7, 1.3, 0.7), 0, 9),
	" ", str(F4(-1.1, 0.2, 0.9, 1.3, 0.7), 0, 9), " ", str(F4(0, 0.4, 0, 1.3, 0.7), 0, 9), "\n")
#declare F5 = function { internal(5) } // f_bifolia
#debug concat("f_bifolia ", str(F5(0.3, 0.5, -0.7, 1.3, 0.7), 0, 9),
	" ", str(F5(-1.1, 0.2, 0.9, 1.3, 0.7), 0, 9), " ", str(F5(0, 0.4, 0, 1.3, 0.7), 0, 9), "\n")
#declare F6 = function { internal(6) } // f_blob
#debug concat("f_blob ", str(F6(0.3, 0.5, -0.7, 1, 1, 0.7, 0.8, 0.6), 0, 9),
	" ", str(F6(-1.1, 0.2, 0.9, 1, 1, 0.7, 0.8, 0.6), 0, 9), " ",
	str(F6(0, 0.4, 0, 1, 1, 0.7, 0.8, 0.6), 0, 9), "\n")
#declare F7 = function { internal(7) } // f_blob2
#debug concat("f_blob2 ", str(F7(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45), 0, 9),
	" ", str(F7(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45), 0, 9), " ",
	str(F7(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45), 0, 9), "\n")
#declare F8 = function { internal(8) } // f_boy_surface
#debug concat("f_boy_surface ", str(F8(0.3, 0.5, -0.7, 1.3, 0.7), 0, 9),
	" ", str(F8(-1.1, 0.2, 0.9, 1.3, 0.7), 0, 9), " ", str(F8(0, 0.4, 0, 1.3, 0.7), 0, 9), "\n")
#declare F9 = function { internal(9) } // f_comma
#debug concat("f_comma ", str(F9(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F9(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F9(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F10 = function { internal(10) } // f_cross_ellipsoids
#debug concat("f_cross_ellipsoids ", str(F10(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45), 0, 9),
	" ", str(F10(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45), 0, 9), " ",
	str(F10(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45), 0, 9), "\n")
#declare F11 = function { internal(11) } // f_crossed_trough
#debug concat("f_crossed_trough ", str(F11(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F11(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F11(0, 0.4, 0, 1.3), 0, 9), "\n")
