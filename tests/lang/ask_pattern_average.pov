// What functions of the pattern average are worth, and what eval_pigment finds of it.
#version 3.7;
#include "functions.inc"
#include "ask.inc"
#declare G = function { pigment { average pigment_map { [1 gradient x][2 bozo color_map { [0 rgb x][1 rgb z] }] } } }
AskColour(G)
#undef G
#declare P = pigment { average pigment_map { [1 gradient x][2 bozo color_map { [0 rgb x][1 rgb z] }] } }
AskPigment(P)
#declare P = pigment { average pigment_map { [1 gradient x][2 bozo color_map { [0 rgb x][1 rgb z] }] } rotate 20 scale <0.7,0.8,1.1> translate 0.1 }
AskPigment(P)
