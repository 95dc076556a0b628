// Colour identifiers are operands of five terms in single precision.
#version 3.7;
#declare C = rgb 0.1;
#declare D = rgb C*0.5;
#declare E = C*0.5;
#debug concat(str(C.red, 0, 15), " ", str(D.red, 0, 15), " ", vstr(5, E, ",", 0, 3), " ",
	str(C.transmit, 0, 0), "\n")
