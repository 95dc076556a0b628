// What trace and inside say of intersection.
#version 3.7;
#include "ask.inc"
#declare O = intersection { sphere { 0, 1.1 } box { -0.8, 0.9 rotate 20*z } }
Ask(O)
#declare O = intersection { sphere { 0, 1.1 } box { -0.8, 0.9 rotate 20*z }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = intersection { sphere { 0, 1.1 } box { -0.8, 0.9 rotate 20*z }  inverse }
Ask(O)
#declare O = intersection { sphere { 0, 1.1 } box { -0.8, 0.9 rotate 20*z }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = intersection { plane { y, 0.3 } plane { -y, 0.3 } sphere { 0, 1.5 inverse } }
Ask(O)
#declare O = intersection { plane { y, 0.3 } plane { -y, 0.3 } sphere { 0, 1.5 inverse }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = intersection { plane { y, 0.3 } plane { -y, 0.3 } sphere { 0, 1.5 inverse }  inverse }
Ask(O)
#declare O = intersection { plane { y, 0.3 } plane { -y, 0.3 } sphere { 0, 1.5 inverse }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
