// What trace and inside say of polygon.
#version 3.7;
#include "ask.inc"
#declare O = polygon { 5, <-1,-1>, <1.2,-1>, <0.9,1>, <0,1.3>, <-1,1> }
AskTrace(O, 14)
#declare O = polygon { 5, <-1,-1>, <1.2,-1>, <0.9,1>, <0,1.3>, <-1,1>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
AskTrace(O, 14)
#declare O = polygon { 10, <-2,-2>, <2,-2>, <2,2>, <-2,2>, <-2,-2>, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1> }
AskTrace(O, 14)
#declare O = polygon { 10, <-2,-2>, <2,-2>, <2,2>, <-2,2>, <-2,-2>, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
AskTrace(O, 14)
