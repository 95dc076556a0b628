// What trace and inside say of torus.
#version 3.7;
#include "ask.inc"
#declare O = torus { 0.9, 0.4 }
Ask(O)
#declare O = torus { 0.9, 0.4  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = torus { 0.9, 0.4  inverse }
Ask(O)
#declare O = torus { 0.9, 0.4  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = torus { 0.5, 0.8 sturm }
Ask(O)
#declare O = torus { 0.5, 0.8 sturm  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = torus { 0.5, 0.8 sturm  inverse }
Ask(O)
#declare O = torus { 0.5, 0.8 sturm  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
