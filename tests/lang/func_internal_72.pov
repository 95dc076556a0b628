// The built-in functions 72 to 78 at some points.
#version 3.7;
#declare F72 = function { internal(72) } // f_torus_gumdrop
#debug concat("f_torus_gumdrop ", str(F72(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F72(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F72(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F73 = function { internal(73) } // f_umbrella
#debug concat("f_umbrella ", str(F73(0.3, 0.5, -0.7, 1.3), 0, 9),
	" ", str(F73(-1.1, 0.2, 0.9, 1.3), 0, 9), " ", str(F73(0, 0.4, 0, 1.3), 0, 9), "\n")
#declare F74 = function { internal(74) } // f_witch_of_agnesi
#debug concat("f_witch_of_agnesi ", str(F74(0.3, 0.5, -0.7, 1.3, 0.7), 0, 9),
	" ", str(F74(-1.1, 0.2, 0.9, 1.3, 0.7), 0, 9), " ", str(F74(0, 0.4, 0, 1.3, 0.7), 0, 9), "\n")
#declare F75 = function { internal(75) } // f_witch_of_agnesi_2d
#debug concat("f_witch_of_agnesi_2d ", str(F75(0.3, 0.5, -0.7, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9),
	" ", str(F75(-1.1, 0.2, 0.9, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), " ",
	str(F75(0, 0.4, 0, 1.3, 0.7, 0.9, 1, 0.45, 25), 0, 9), "\n")
#declare F76 = function { internal(76) } // f_noise3d
#debug concat("f_noise3d ", str(F76(0.3, 0.5, -0.7), 0, 9),
	" ", str(F76(-1.1, 0.2, 0.9), 0, 9), " ", str(F76(0, 0.4, 0), 0, 9), "\n")
#declare F78 = function { internal(78) } // f_noise_generator
#debug concat("f_noise_generator ", str(F78(0.3, 0.5, -0.7, 3), 0, 9),
	" ", str(F78(-1.1, 0.2, 0.9, 3), 0, 9), " ", str(F78(0, 0.4, 0, 3), 0, 9), "\n")
