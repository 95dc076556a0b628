// What trace and inside say of triangle.
#version 3.7;
#include "ask.inc"
#declare O = triangle { <-2,-1,0.3>, <2,-1,-0.3>, <0.2,2,0.4> }
AskTrace(O, 14)
#declare O = triangle { <-2,-1,0.3>, <2,-1,-0.3>, <0.2,2,0.4>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
AskTrace(O, 14)
