// What clips has no texture.
#version 3.7;
sphere { 0, 1 clipped_by { box { 0, 1 pigment { rgb 1 } } } }
