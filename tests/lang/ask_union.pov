// What trace and inside say of union.
#version 3.7;
#include "ask.inc"
#declare O = union { sphere { 0, 0.8 } box { 0, 1 } }
Ask(O)
#declare O = union { sphere { 0, 0.8 } box { 0, 1 }  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = union { sphere { 0, 0.8 } box { 0, 1 }  inverse }
Ask(O)
#declare O = union { sphere { 0, 0.8 } box { 0, 1 }  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = union { sphere { 0, 0.8 } box { 0, 1 rotate 20*y } split_union off }
Ask(O)
#declare O = union { sphere { 0, 0.8 } box { 0, 1 rotate 20*y } split_union off  rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = union { sphere { 0, 0.8 } box { 0, 1 rotate 20*y } split_union off  inverse }
Ask(O)
#declare O = union { sphere { 0, 0.8 } box { 0, 1 rotate 20*y } split_union off  inverse rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
