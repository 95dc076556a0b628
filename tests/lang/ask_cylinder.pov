// What trace and inside say of cylinder.
#version 3.7;
#include "ask.inc"
#declare O = cylinder { <-0.5,-1,0.2>, <0.4,1,0.3>, 0.8 }
Ask(O)
#declare O = cylinder { <-0.5,-1,0.2>, <0.4,1,0.3>, 0.8  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cylinder { <-0.5,-1,0.2>, <0.4,1,0.3>, 0.8  inverse }
Ask(O)
#declare O = cylinder { <-0.5,-1,0.2>, <0.4,1,0.3>, 0.8  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cylinder { <-0.5,-1,0.2>, <0.4,1,0.3>, 0.8 open }
Ask(O)
#declare O = cylinder { <-0.5,-1,0.2>, <0.4,1,0.3>, 0.8 open  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cylinder { <-0.5,-1,0.2>, <0.4,1,0.3>, 0.8 open  inverse }
Ask(O)
#declare O = cylinder { <-0.5,-1,0.2>, <0.4,1,0.3>, 0.8 open  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
