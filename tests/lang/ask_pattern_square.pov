// What functions of the pattern square are worth, and what eval_pigment finds of it.
#version 3.7;
#include "functions.inc"
#include "ask.inc"
#declare G = function { pigment { square rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2>, rgb z, rgb <0.3,0.6,0> } }
AskColour(G)
#undef G
#declare P = pigment { square rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2>, rgb z, rgb <0.3,0.6,0> }
AskPigment(P)
#declare P = pigment { square rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2>, rgb z, rgb <0.3,0.6,0> rotate 20 scale <0.7,0.8,1.1> translate 0.1 }
AskPigment(P)
