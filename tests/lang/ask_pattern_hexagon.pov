// What functions of the pattern hexagon are worth, and what eval_pigment finds of it.
#version 3.7;
#include "functions.inc"
#include "ask.inc"
#declare F = function { pattern { hexagon } }
AskPattern(F)
#undef F
#declare G = function { pigment { hexagon rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2>, rgb z } }
AskColour(G)
#undef G
#declare P = pigment { hexagon rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2>, rgb z }
AskPigment(P)
#declare P = pigment { hexagon rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2>, rgb z rotate 20 scale <0.7,0.8,1.1> translate 0.1 }
AskPigment(P)
