// What trace and inside say of clipped.
#version 3.7;
#include "ask.inc"
#declare O = sphere { 0, 1.2 clipped_by { plane { y, 0.3 } } }
Ask(O)
#declare O = sphere { 0, 1.2 clipped_by { plane { y, 0.3 } }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = sphere { 0, 1.2 clipped_by { plane { y, 0.3 } }  inverse }
Ask(O)
#declare O = sphere { 0, 1.2 clipped_by { plane { y, 0.3 } }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = torus { 0.9, 0.4 clipped_by { box { -1, <0.5,1,1> } sphere { 0, 1.1 } } }
Ask(O)
#declare O = torus { 0.9, 0.4 clipped_by { box { -1, <0.5,1,1> } sphere { 0, 1.1 } }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = torus { 0.9, 0.4 clipped_by { box { -1, <0.5,1,1> } sphere { 0, 1.1 } }  inverse }
Ask(O)
#declare O = torus { 0.9, 0.4 clipped_by { box { -1, <0.5,1,1> } sphere { 0, 1.1 } }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = difference { sphere { 0, 1.2 } sphere { 0, 1 } clipped_by { plane { x + y, 0.2 } } }
Ask(O)
#declare O = difference { sphere { 0, 1.2 } sphere { 0, 1 } clipped_by { plane { x + y, 0.2 } }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = difference { sphere { 0, 1.2 } sphere { 0, 1 } clipped_by { plane { x + y, 0.2 } }  inverse }
Ask(O)
#declare O = difference { sphere { 0, 1.2 } sphere { 0, 1 } clipped_by { plane { x + y, 0.2 } }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = box { -1, 1 clipped_by { cylinder { -2*z, 2*z, 0.8 } } bounded_by { clipped_by } }
Ask(O)
#declare O = box { -1, 1 clipped_by { cylinder { -2*z, 2*z, 0.8 } } bounded_by { clipped_by }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = box { -1, 1 clipped_by { cylinder { -2*z, 2*z, 0.8 } } bounded_by { clipped_by }  inverse }
Ask(O)
#declare O = box { -1, 1 clipped_by { cylinder { -2*z, 2*z, 0.8 } } bounded_by { clipped_by }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = text { ttf "timrom.ttf" "Ab%" 0.5, 0 translate <-0.7,-0.3,-0.2> clipped_by { box { -0.5, 0.5 } } }
Ask(O)
#declare O = text { ttf "timrom.ttf" "Ab%" 0.5, 0 translate <-0.7,-0.3,-0.2> clipped_by { box { -0.5, 0.5 } }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = text { ttf "timrom.ttf" "Ab%" 0.5, 0 translate <-0.7,-0.3,-0.2> clipped_by { box { -0.5, 0.5 } }  inverse }
Ask(O)
#declare O = text { ttf "timrom.ttf" "Ab%" 0.5, 0 translate <-0.7,-0.3,-0.2> clipped_by { box { -0.5, 0.5 } }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
