// atan2 of two zeros.
#version 3.7;
#declare A = atan2(0, 1e-11);
