// What functions of the pattern wrinkles are worth, and what eval_pigment finds of it.
#version 3.7;
#include "functions.inc"
#include "ask.inc"
#declare F = function { pattern { wrinkles } }
AskPattern(F)
#undef F
#declare G = function { pigment { wrinkles color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } } }
AskColour(G)
#undef G
#declare P = pigment { wrinkles color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } }
AskPigment(P)
#declare P = pigment { wrinkles color_map { [0 rgb <1,0.2,0.1>][0.5 rgbft <0.2,0.9,0.4,0.3,0.2>][1 rgb <0,0.3,1>] } rotate 20 scale <0.7,0.8,1.1> translate 0.1 }
AskPigment(P)
