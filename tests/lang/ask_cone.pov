// What trace and inside say of cone.
#version 3.7;
#include "ask.inc"
#declare O = cone { <-0.5,-1,0.2>, 1, <0.4,1,0.3>, 0.3 }
Ask(O)
#declare O = cone { <-0.5,-1,0.2>, 1, <0.4,1,0.3>, 0.3  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cone { <-0.5,-1,0.2>, 1, <0.4,1,0.3>, 0.3  inverse }
Ask(O)
#declare O = cone { <-0.5,-1,0.2>, 1, <0.4,1,0.3>, 0.3  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cone { <-0.5,-1,0.2>, 1, <0.4,1,0.3>, 0.3 open }
Ask(O)
#declare O = cone { <-0.5,-1,0.2>, 1, <0.4,1,0.3>, 0.3 open  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cone { <-0.5,-1,0.2>, 1, <0.4,1,0.3>, 0.3 open  inverse }
Ask(O)
#declare O = cone { <-0.5,-1,0.2>, 1, <0.4,1,0.3>, 0.3 open  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cone { -y, 0, y, 1.2 }
Ask(O)
#declare O = cone { -y, 0, y, 1.2  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cone { -y, 0, y, 1.2  inverse }
Ask(O)
#declare O = cone { -y, 0, y, 1.2  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cone { -y, 1, y, 1 }
Ask(O)
#declare O = cone { -y, 1, y, 1  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = cone { -y, 1, y, 1  inverse }
Ask(O)
#declare O = cone { -y, 1, y, 1  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
