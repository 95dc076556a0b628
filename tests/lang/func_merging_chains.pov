// Longer chains of constants, each level for itself.
#version 3.7;
#declare A = function(x) { 2*3*x*4*5 }
#declare B = function(x) { x*2/4*8/2 }
#declare C = function(x) { 8/2/2*x/4/2 }
#declare D = function(x) { 1 - 2 - 3*4 - x - 5*6 - 7 + 8 }
#declare E = function(x) { x + 2*3 - 4*5 + 6/3 - 2 }
#declare F = function(x) { -2*3 - x - -3*4 + -5 }
#declare G = function(x) { 1 < 2 < x < 4 < 5 }
#declare H = function(x) { 1 & 0 | x & 1 & 1 | 0 | 1 & 0 }
#declare I = function(x) { x = 2 = 1 = 1 }
#declare J = function(x) { 5 - (2 - 3 - x) - (1 - 2) - 4 }
#macro Show(F) #debug concat(str(F(0), 0, 6), " ", str(F(2), 0, 6), " ", str(F(-3), 0, 6),
	"\n") #end
Show(A) Show(B) Show(C) Show(D) Show(E) Show(F) Show(G) Show(H) Show(I) Show(J)
