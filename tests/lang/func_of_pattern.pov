// A function of a pattern is its value.
#version 3.7;
#declare A = function { pattern { gradient x } }
#declare B = function { pattern { wood turbulence 0.1 scale 0.3 } }
#declare C = function { pattern { checker } }
#declare D = function { pattern { granite } }
#declare E = function { pattern { crackle solid } }
#declare F = function { pattern { bozo sine_wave frequency 2 phase 0.3 } }
#declare G = function { pattern { leopard } }
#declare H = function { pattern { marble poly_wave 2 } }
#macro Show(F) #debug concat(str(F(0.3, 0.7, -1.2), 0, 6), " ", str(F(-2.3, 1.7, 4.4), 0, 6),
	"\n") #end
Show(A) Show(B) Show(C) Show(D) Show(E) Show(F) Show(G) Show(H)
