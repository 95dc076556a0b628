// What functions of the pattern crackle are worth, and what eval_pigment finds of it.
#version 3.7;
#include "functions.inc"
#include "ask.inc"
#declare F = function { pattern { crackle } }
AskPattern(F)
#undef F
#declare G = function { pigment { crackle color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } } }
AskColour(G)
#undef G
#declare P = pigment { crackle color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } }
AskPigment(P)
#declare P = pigment { crackle color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } rotate 20 scale <0.7,0.8,1.1> translate 0.1 }
AskPigment(P)
#declare F = function { pattern { crackle form <1,0.5,0> metric 1 offset 0.3 } }
AskPattern(F)
#undef F
#declare G = function { pigment { crackle form <1,0.5,0> metric 1 offset 0.3 color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } } }
AskColour(G)
#undef G
#declare P = pigment { crackle form <1,0.5,0> metric 1 offset 0.3 color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } }
AskPigment(P)
#declare P = pigment { crackle form <1,0.5,0> metric 1 offset 0.3 color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } rotate 20 scale <0.7,0.8,1.1> translate 0.1 }
AskPigment(P)
#declare F = function { pattern { crackle solid scale 0.4 } }
AskPattern(F)
#undef F
#declare G = function { pigment { crackle solid color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } scale 0.4 } }
AskColour(G)
#undef G
#declare P = pigment { crackle solid color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } scale 0.4 }
AskPigment(P)
#declare P = pigment { crackle solid color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } scale 0.4 rotate 20 scale <0.7,0.8,1.1> translate 0.1 }
AskPigment(P)
