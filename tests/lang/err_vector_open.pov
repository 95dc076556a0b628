// A vector that is not closed is called so, in blocks and in declarations.
#version 3.7;
camera { location <0, 1 -5 look_at <0, 1, 0> }
sphere { 0, 1 pigment { rgb <1, 0, 0 } }
#declare A = <1, 2;
