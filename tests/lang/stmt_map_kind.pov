// A map belongs to its own kind of block.
#version 3.7;
sphere { 0, 1 pigment { bozo normal_map { [0 bumps] } } }
