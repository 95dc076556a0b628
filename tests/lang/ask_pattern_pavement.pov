// What eval_pigment finds of the pattern pavement: each pavement once, its corners in turns.
#version 3.7;
#include "functions.inc"
#include "ask.inc"
#macro AskPavement(Sides, Tiles, Pattern, I)
	#declare P = pigment { pavement number_of_sides Sides number_of_tiles Tiles pattern Pattern
		exterior mod(I, 4) interior mod(int(I/2), 4) form mod(int(I/3), 5) scale 0.2 }
	AskPigment(P)
#end
#declare Number = 0;
#for (I, 1, 1)
	#declare Number = Number + 1;
	AskPavement(3, 1, I, Number)
#end
#for (I, 1, 1)
	#declare Number = Number + 1;
	AskPavement(3, 2, I, Number)
#end
#for (I, 1, 1)
	#declare Number = Number + 1;
	AskPavement(3, 3, I, Number)
#end
#for (I, 1, 3)
	#declare Number = Number + 1;
	AskPavement(3, 4, I, Number)
#end
#for (I, 1, 4)
	#declare Number = Number + 1;
	AskPavement(3, 5, I, Number)
#end
#for (I, 1, 12)
	#declare Number = Number + 1;
	AskPavement(3, 6, I, Number)
#end
#for (I, 1, 1)
	#declare Number = Number + 1;
	AskPavement(4, 1, I, Number)
#end
#for (I, 1, 1)
	#declare Number = Number + 1;
	AskPavement(4, 2, I, Number)
#end
#for (I, 1, 2)
	#declare Number = Number + 1;
	AskPavement(4, 3, I, Number)
#end
#for (I, 1, 5)
	#declare Number = Number + 1;
	AskPavement(4, 4, I, Number)
#end
#for (I, 1, 12)
	#declare Number = Number + 1;
	AskPavement(4, 5, I, Number)
#end
#for (I, 1, 35)
	#declare Number = Number + 1;
	AskPavement(4, 6, I, Number)
#end
#for (I, 1, 1)
	#declare Number = Number + 1;
	AskPavement(6, 1, I, Number)
#end
#for (I, 1, 1)
	#declare Number = Number + 1;
	AskPavement(6, 2, I, Number)
#end
#for (I, 1, 3)
	#declare Number = Number + 1;
	AskPavement(6, 3, I, Number)
#end
#for (I, 1, 7)
	#declare Number = Number + 1;
	AskPavement(6, 4, I, Number)
#end
#for (I, 1, 22)
	#declare Number = Number + 1;
	AskPavement(6, 5, I, Number)
#end
AskPavement(3, 6, 1, 0)
AskPavement(4, 6, 2, 5)
AskPavement(3, 6, 3, 10)
AskPavement(4, 6, 4, 15)
AskPavement(3, 6, 5, 20)
AskPavement(4, 6, 6, 25)
AskPavement(3, 6, 7, 30)
AskPavement(4, 6, 8, 35)
AskPavement(3, 6, 9, 40)
AskPavement(4, 6, 10, 45)
AskPavement(3, 6, 11, 50)
AskPavement(4, 6, 12, 55)
AskPavement(3, 6, 1, 60)
AskPavement(4, 6, 2, 65)
AskPavement(3, 6, 3, 70)
AskPavement(4, 6, 4, 75)
AskPavement(3, 6, 5, 80)
AskPavement(4, 6, 6, 85)
AskPavement(3, 6, 7, 90)
AskPavement(4, 6, 8, 95)
AskPavement(3, 6, 9, 100)
AskPavement(4, 6, 10, 105)
AskPavement(3, 6, 11, 110)
AskPavement(4, 6, 12, 115)
#declare P = pigment { pavement }
AskPigment(P)
