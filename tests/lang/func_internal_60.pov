// The built-in functions 60 to 71 at some points.
#version 3.7;
#declare F60 = function { internal(60) } // f_rounded_box
#debug concat("f_rounded_box ", str(F60(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45), 0, 9),
	" ", str(F60(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45), 0, 9), " ",
	str(F60(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45), 0, 9), "\n")
#declare F61 = function { internal(61) } // f_sphere
#debug concat("f_sphere ", str(F61(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F61(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F61(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F62 = function { internal(62) } // f_spikes
#debug concat("f_spikes ", str(F62(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45, 0.6), 0, 9),
	" ", str(F62(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45, 0.6), 0, 9), " ",
	str(F62(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45, 0.6), 0, 9), "\n")
#declare F63 = function { internal(63) } // f_spikes_2d
#debug concat("f_spikes_2d ", str(F63(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45), 0, 9),
	" ", str(F63(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45), 0, 9), " ",
	str(F63(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45), 0, 9), "\n")
#declare F64 = function { internal(64) } // f_spiral
#debug concat("f_spiral ", str(F64(0.3, 0.5, -0.7, 0.7, 0.1, 2.5, 1, 1, 0.6), 0, 9),
	" ", str(F64(-1.1, 0.2, 0.9, 0.7, 0.1, 2.5, 1, 1, 0.6), 0, 9), " ",
	str(F64(0, 0.4, 0, 0.7, 0.1, 2.5, 1, 1, 0.6), 0, 9), "\n")
#declare F65 = function { internal(65) } // f_steiners_roman
#debug concat("f_steiners_roman ", str(F65(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F65(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F65(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F66 = function { internal(66) } // f_strophoid
#debug concat("f_strophoid ", str(F66(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45), 0, 9),
	" ", str(F66(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45), 0, 9), " ",
	str(F66(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45), 0, 9), "\n")
#declare F67 = function { internal(67) } // f_strophoid_2d
#debug concat("f_strophoid_2d ", str(F67(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 0.45, 1, 0.4, 25), 0, 9),
	" ", str(F67(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 0.45, 1, 0.4, 25), 0, 9), " ",
	str(F67(0, 0.4, 0, 1.3, 0.7, 0.9, 0.45, 1, 0.4, 25), 0, 9), "\n")
#declare F68 = function { internal(68) } // f_superellipsoid
#debug concat("f_superellipsoid ", str(F68(0.3, 0.5, -0.7, 0.4, 0.7), 0, 9),
	" ", str(F68(-1.1, 0.2, 0.9, 0.4, 0.7), 0, 9), " ", str(F68(0, 0.4, 0, 0.4, 0.7), 0, 9), "\n")
#declare F69 = function { internal(69) } // f_th
#debug concat("f_th ", str(F69(0.3, 0.5, -0.7), 0, 9),
	" ", str(F69(-1.1, 0.2, 0.9), 0, 9), " ", str(F69(0, 0.4, 0), 0, 9), "\n")
#declare F70 = function { internal(70) } // f_torus
#debug concat("f_torus ", str(F70(0.3, 0.5, -0.7, 1.3, 0.7), 0, 9),
	" ", str(F70(-1.1, 0.2, 0.9, 1.3, 0.7), 0, 9), " ", str(F70(0, 0.4, 0, 1.3, 0.7), 0, 9), "\n")
#declare F71 = function { internal(71) } // f_torus2
#debug concat("f_torus2 ", str(F71(0.3, 0.5, -0.7, 1.3, 0.7, 0.9), 0, 9),
	" ", str(F71(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9), 0, 9), " ",
	str(F71(0, 0.4, 0, 1.3, 0.7, 0.9), 0, 9), "\n")
