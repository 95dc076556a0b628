// What trace and inside say of quadric.
#version 3.7;
#include "ask.inc"
#declare O = quadric { <1,1,1>,0,0,-1 }
Ask(O)
#declare O = quadric { <1,1,1>,0,0,-1  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = quadric { <1,1,1>,0,0,-1  inverse }
Ask(O)
#declare O = quadric { <1,1,1>,0,0,-1  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = quadric { <1,-0.5,1>,<0.2,0,0.1>,<0,0.3,0>,-0.3 }
Ask(O)
#declare O = quadric { <1,-0.5,1>,<0.2,0,0.1>,<0,0.3,0>,-0.3  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = quadric { <1,-0.5,1>,<0.2,0,0.1>,<0,0.3,0>,-0.3  inverse }
Ask(O)
#declare O = quadric { <1,-0.5,1>,<0.2,0,0.1>,<0,0.3,0>,-0.3  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = quadric { <1,0,1>,0,<0,-1,0>,0 }
Ask(O)
#declare O = quadric { <1,0,1>,0,<0,-1,0>,0  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = quadric { <1,0,1>,0,<0,-1,0>,0  inverse }
Ask(O)
#declare O = quadric { <1,0,1>,0,<0,-1,0>,0  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
