// What trace and inside say of polynomial: commas may be missing, the last of two equal terms counts.
#version 3.7;
#include "ask.inc"
#declare O = polynomial { 2, xyz(2,0,0):1, xyz(0,2,0):1 xyz(0 0 2):1 xyz(0,0,0):5, xyz(0,0,0):-1 }
Ask(O)
#declare O = polynomial { 5 xyz(5,0,0):1, xyz(4,0,0):.3 xyz(0,4,0):.4, xyz(1,0,2):.25, xyz(0,1,2):.15, xyz(1,1,1):.35, xyz(0,0,4):.3 xyz(0,0,0):-.3 rotate <30,40,50> scale <0.7,1.2,0.9> translate <0.3,-0.2,0.1> }
Ask(O)
#declare O = polynomial { 4 xyz(4,0,0):1, xyz(0,4,0):.4, xyz(0,0,4):.3 xyz(1,2,1):.2 xyz(0,1.7,3):.3 xyz(0,0,0):-.3 sturm inverse }
Ask(O)
#declare O = polynomial { 3.9 xyz(2,0,0):1 xyz(0,2,0):1 xyz(0,0,2):1 xyz(0,0,0):-.5 }
Ask(O)
