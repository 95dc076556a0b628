// A name that is declared further down: the place is shown.
#version 3.7;
#declare Sizes = 3;
sphere { 0, Size }
box { 0, Soze }
// #declare Soze = 1;
#declare Size = 2;
