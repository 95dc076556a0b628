// What trace and inside say of disc.
#version 3.7;
#include "ask.inc"
#declare O = disc { 0.2*y, <1,2,1>, 1.3 }
Ask(O)
#declare O = disc { 0.2*y, <1,2,1>, 1.3  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = disc { 0.2*y, <1,2,1>, 1.3, 0.4 }
Ask(O)
#declare O = disc { 0.2*y, <1,2,1>, 1.3, 0.4  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
