// What trace and inside say of difference.
#version 3.7;
#include "ask.inc"
#declare O = difference { sphere { 0, 1.1 } box { 0, 1 } cylinder { -2*x, 2*x, 0.3 } }
Ask(O)
#declare O = difference { sphere { 0, 1.1 } box { 0, 1 } cylinder { -2*x, 2*x, 0.3 }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = difference { sphere { 0, 1.1 } box { 0, 1 } cylinder { -2*x, 2*x, 0.3 }  inverse }
Ask(O)
#declare O = difference { sphere { 0, 1.1 } box { 0, 1 } cylinder { -2*x, 2*x, 0.3 }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
