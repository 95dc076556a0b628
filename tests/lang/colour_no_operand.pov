// Colour words are no operands.
#version 3.7;
#declare C = 2*rgb <1, 0, 0>;
