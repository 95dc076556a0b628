// Behind values that are no expressions the semicolon is optional.
#version 3.7;
#declare A = "string" #declare B = sphere { 0, 1 } #declare C = B #declare D = array[1] { 1 }
	#declare E = D
#declare F = function(x) { x } #declare G = pigment { rgb 1 }; #declare H = "string";
#debug A #debug "\n"
