// What trace and inside say of plane.
#version 3.7;
#include "ask.inc"
#declare O = plane { <1,2,3>, 0.3 }
Ask(O)
#declare O = plane { <1,2,3>, 0.3  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = plane { <1,2,3>, 0.3  inverse }
Ask(O)
#declare O = plane { <1,2,3>, 0.3  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
