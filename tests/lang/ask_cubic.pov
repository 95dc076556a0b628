// What trace and inside say of cubic.
#version 3.7;
#include "ask.inc"
#declare O = cubic { <1,0,0,-0.5, 0,0.2,0,0, 0.3,1,1,0, 0,0,0.4,0, 0,1,0,0.2> }
Ask(O)
#declare O = cubic { <1,0,0,-0.5, 0,0.2,0,0, 0.3,1,1,0, 0,0,0.4,0, 0,1,0,0.2>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cubic { <1,0,0,-0.5, 0,0.2,0,0, 0.3,1,1,0, 0,0,0.4,0, 0,1,0,0.2>  inverse }
Ask(O)
#declare O = cubic { <1,0,0,-0.5, 0,0.2,0,0, 0.3,1,1,0, 0,0,0.4,0, 0,1,0,0.2>  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
