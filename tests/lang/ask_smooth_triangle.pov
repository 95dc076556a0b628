// What trace and inside say of smooth_triangle.
#version 3.7;
#include "ask.inc"
#declare O = smooth_triangle { <-2,-1,0.3>, <-1,-1,1>, <2,-1,-0.3>, <1,-1,1>, <0.2,2,0.4>, <0,1,1> }
AskTrace(O, 14)
#declare O = smooth_triangle { <-2,-1,0.3>, <-1,-1,1>, <2,-1,-0.3>, <1,-1,1>, <0.2,2,0.4>, <0,1,1>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
AskTrace(O, 14)
