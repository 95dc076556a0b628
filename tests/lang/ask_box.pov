// What trace and inside say of box.
#version 3.7;
#include "ask.inc"
#declare O = box { <-1,-0.5,-0.7>, <0.9,1.1,0.8> }
Ask(O)
#declare O = box { <-1,-0.5,-0.7>, <0.9,1.1,0.8>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = box { <-1,-0.5,-0.7>, <0.9,1.1,0.8>  inverse }
Ask(O)
#declare O = box { <-1,-0.5,-0.7>, <0.9,1.1,0.8>  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
