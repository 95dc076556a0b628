// What trace and inside say of bounded.
#version 3.7;
#include "ask.inc"
#declare O = sphere { 0, 1.2 bounded_by { box { -1.3, 1.3 } } }
Ask(O)
#declare O = sphere { 0, 1.2 bounded_by { box { -1.3, 1.3 } }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = sphere { 0, 1.2 bounded_by { box { -1.3, 1.3 } }  inverse }
Ask(O)
#declare O = sphere { 0, 1.2 bounded_by { box { -1.3, 1.3 } }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = union { sphere { 0, 1 } sphere { x, 1 } bounded_by { box { -1, 0.5 } } }
Ask(O)
#declare O = union { sphere { 0, 1 } sphere { x, 1 } bounded_by { box { -1, 0.5 } }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = union { sphere { 0, 1 } sphere { x, 1 } bounded_by { box { -1, 0.5 } }  inverse }
Ask(O)
#declare O = union { sphere { 0, 1 } sphere { x, 1 } bounded_by { box { -1, 0.5 } }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
