// What trace and inside say of superellipsoid.
#version 3.7;
#include "ask.inc"
#declare O = superellipsoid { <0.5,0.7> }
Ask(O)
#declare O = superellipsoid { <0.5,0.7>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = superellipsoid { <0.5,0.7>  inverse }
Ask(O)
#declare O = superellipsoid { <0.5,0.7>  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = superellipsoid { <0.25,1.5> }
Ask(O)
#declare O = superellipsoid { <0.25,1.5>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = superellipsoid { <0.25,1.5>  inverse }
Ask(O)
#declare O = superellipsoid { <0.25,1.5>  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = superellipsoid { <1,1> }
Ask(O)
#declare O = superellipsoid { <1,1>  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = superellipsoid { <1,1>  inverse }
Ask(O)
#declare O = superellipsoid { <1,1>  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
