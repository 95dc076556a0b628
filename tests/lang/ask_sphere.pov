// What trace and inside say of sphere.
#version 3.7;
#include "ask.inc"
#declare O = sphere { <0.1,0.2,0.3>, 1.1 }
Ask(O)
#declare O = sphere { <0.1,0.2,0.3>, 1.1  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = sphere { <0.1,0.2,0.3>, 1.1  inverse }
Ask(O)
#declare O = sphere { <0.1,0.2,0.3>, 1.1  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
