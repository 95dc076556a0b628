// What functions of the pattern brick are worth, and what eval_pigment finds of it.
#version 3.7;
#include "functions.inc"
#include "ask.inc"
#declare F = function { pattern { brick } }
AskPattern(F)
#undef F
#declare G = function { pigment { brick rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2> } }
AskColour(G)
#undef G
#declare P = pigment { brick rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2> }
AskPigment(P)
#declare P = pigment { brick rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2> rotate 20 scale <0.7,0.8,1.1> translate 0.1 }
AskPigment(P)
#declare F = function { pattern { brick brick_size <1,2,3>*0.3 mortar 0.1 } }
AskPattern(F)
#undef F
#declare G = function { pigment { brick rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2> brick_size <1,2,3>*0.3 mortar 0.1 } }
AskColour(G)
#undef G
#declare P = pigment { brick rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2> brick_size <1,2,3>*0.3 mortar 0.1 }
AskPigment(P)
#declare P = pigment { brick rgb <1,0.2,0.1>, rgbft <0.2,0.9,0.4,0.3,0.2> brick_size <1,2,3>*0.3 mortar 0.1 rotate 20 scale <0.7,0.8,1.1> translate 0.1 }
AskPigment(P)
