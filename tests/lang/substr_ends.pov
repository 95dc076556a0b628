// Position 0, one before the first character, gives nothing; one behind the last may be named.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(From, Count)
	#debug concat("[", substr("abc", From, Count), "] ", str(strlen(substr("abc", From, Count)), 0, 0), "\n")
#end
Show(0, 0) Show(0, 1) Show(0, 2) Show(0, 3) Show(0, 4)
Show(1, 0) Show(4, 0) Show(1, 3) Show(3, 1) Show(1.9, 1) Show(2, 1.9) Show(0.5, 2) Show(-0.5, 2) Show(1, -0.5)
#debug concat("[", substr("", 0, 0), substr("", 1, 0), substr("", 0, 1), "]\n")
sphere { 0, 1 }
