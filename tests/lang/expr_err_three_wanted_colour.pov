// A colour where a 3-vector is wanted is an error.
#version 3.7;
#declare C = rgb 1;
sphere { C, 1 }
